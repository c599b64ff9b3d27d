// SPDX-License-Identifier: BSD-3-Clause
// The options by which one film is told from another.
#ifndef WideFoVFilmIdentity_h
#define WideFoVFilmIdentity_h

#include <string>

namespace CLI
{
class App;
}

namespace widefov
{
// A line for each option that is given, on the command line, in a file or by a preset, and that
// changes the frames: "--hfov 90". Of files the name without its folder.
std::string FilmIdentity(const CLI::App& app);

// The first option that differs: "--hfov is 90, and 180 there". Empty if the films are the same.
std::string FilmDifference(const std::string& here, const std::string& there);
}

#endif
