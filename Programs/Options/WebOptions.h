// SPDX-License-Identifier: BSD-3-Clause
// The options of web pages on the command line.
#ifndef WideFoVWebOptions_h
#define WideFoVWebOptions_h

#include "OptionGroup.h"
#include "Options.h"

namespace widefov
{
void DeclareWeb(CLI::App& app, Options& options);

// After parsing: sets the layout of two eyes and the file of a film to those of the page.
void CompleteWeb(Options& options);

// After everything is known. Throws a Failure with ExitUsage for a view that no page can show.
void CheckWeb(const Options& options);
}

#endif
