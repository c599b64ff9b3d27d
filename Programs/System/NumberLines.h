// SPDX-License-Identifier: BSD-3-Clause
// Text files of numbers: a record a line, blanks between; lines that begin with # are comments.
#ifndef WideFoVNumberLines_h
#define WideFoVNumberLines_h

#include <string>
#include <vector>

namespace widefov
{
struct NumberLine
{
  std::string Where; // the file and the line's number, for messages
  std::vector<double> Numbers;
};

// All lines that are not empty. `what` the file ought to hold. Throws a Failure with ExitFailed
// that names the line: no file, no number, one that is not finite.
std::vector<NumberLine> ReadNumberLines(const std::string& path, const std::string& what);
}

#endif
