// SPDX-License-Identifier: BSD-3-Clause
// Names of picture files: the format that an ending means, and a name for each eye, screen and
// pose.
#ifndef WideFoVOutputNames_h
#define WideFoVOutputNames_h

#include "Options.h"

#include <string>
#include <vector>

namespace widefov
{
// OpenImageIO's name of the writer for the ending of the file; empty if there is none.
std::string WriterFor(const std::string& path);

// Throw a Failure with ExitUsage if files with this ending cannot be written.
void CheckPictureName(const std::string& path);
void CheckAovName(const std::string& path);

// True if a file with this name can keep several views.
bool IsMultiViewName(const std::string& path);

// True if the name is that of a VR180 photo, NAME.vr.jpg.
bool IsVr180Photo(const std::string& path);

// The files that an output file becomes: two if each eye has its own.
std::vector<std::string> FilesOf(const Options& options, const std::string& output);
}

#endif
