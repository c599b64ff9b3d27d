// SPDX-License-Identifier: BSD-3-Clause
// Which files a picture becomes, and what is in them.
#ifndef WideFoVPictureFiles_h
#define WideFoVPictureFiles_h

#include "ImageOutput.h"
#include "Options/Options.h"

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace widefov
{
// Names and bytes of the files of one --output, from the pictures that were drawn: one, or one
// of each eye; none where there are none.
std::vector<std::pair<std::string, std::vector<unsigned char>>> EncodeFiles(
  const Options& options, const std::string& output, const std::vector<Picture>& drawn);

// Width and height of the picture in a file, as the layout of stereo arranges it.
std::array<int, 2> SizeOfFile(const Options& options);
}

#endif
