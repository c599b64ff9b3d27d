// SPDX-License-Identifier: BSD-3-Clause
// What a benchmark ran on.
#ifndef WideFoVEnvironment_h
#define WideFoVEnvironment_h

#include "Record.h"

namespace wfv
{
namespace bench
{
// GL strings, versions, processor and cores. Opens a window. Throws a Failure with
// ExitFailed where there is no display.
Json DescribeEnvironment();
}
}

#endif
