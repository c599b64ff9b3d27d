// SPDX-License-Identifier: BSD-3-Clause
// What is said once in a process, however many frames and props it is true of.
#ifndef WideFoVReports_h
#define WideFoVReports_h

#include "Projections/Projection.h"

#include <string>

namespace wfv
{
// True the first time that it is asked of this text.
bool IsNews(const std::string& text);

// Of a text that says how much or how many: for texts that are the same but for that.
std::string WithoutNumbers(std::string text);

// As if nothing had been said yet: for tests.
WFV_EXPORT void ForgetReports();
}

#endif
