// SPDX-License-Identifier: BSD-3-Clause
// The options of films on the command line.
#ifndef WideFoVFilmOptions_h
#define WideFoVFilmOptions_h

#include "OptionGroup.h"
#include "Options.h"

#include <string>
#include <vector>

namespace widefov
{
void DeclareFilm(CLI::App& app, Options& options);

// After parsing: what the preset and the options as a whole say of the film.
void CompleteFilm(const CLI::App& app, Options& options);

bool HasFilm(const Options& options);

// A path or a flight: the places of the eye are those of a file, or of the data.
bool SaysWhereTheEyeGoes(const FilmOptions& film);

// After everything is known. Throws a Failure with ExitUsage for an option that does not go with
// the film, or for one of films where there is none.
void CheckFilm(const Options& options);

// The files that an output of a film becomes: two where each eye has its own. Of numbered frames
// the names with their pattern: frames/left/%05d.png.
std::vector<std::string> FilesOfFilm(const Options& options, const std::string& output);
}

#endif
