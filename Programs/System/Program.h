// SPDX-License-Identifier: BSD-3-Clause
// What is around the work of every program: messages and exit codes.
#ifndef WideFoVProgram_h
#define WideFoVProgram_h

#include <functional>
#include <string>

namespace widefov
{
// Runs `work` under that name and returns the exit code: what it returns, or that of the
// Failure it throws, whose text goes to standard error in one line.
int RunProgram(const std::string& name, const std::function<int()>& work);
}

#endif
