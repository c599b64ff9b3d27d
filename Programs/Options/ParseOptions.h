// SPDX-License-Identifier: BSD-3-Clause
// Declares and parses the options of programs that draw a scene.
#ifndef WideFoVParseOptions_h
#define WideFoVParseOptions_h

#include "FieldsOfView.h"
#include "Options.h"

#include <optional>

namespace CLI
{
class App;
}

namespace widefov
{
// Declares what every program takes that draws a scene: data, view, drawing, stereo, lists.
// The targets must outlive the parsing.
void DeclareScene(CLI::App& app, Options& options, FieldsOfView& fov);

// Parses and checks the command line of widefov-render. Throws a Failure with ExitUsage; returns an
// exit code where nothing is left to do (--help was printed).
std::optional<int> ParseOptions(int argc, char** argv, Options& options);
}

#endif
