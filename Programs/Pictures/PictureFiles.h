// SPDX-License-Identifier: BSD-3-Clause
// Which files a picture becomes, and what is in them.
#ifndef WideFoVPictureFiles_h
#define WideFoVPictureFiles_h

#include "Options/Options.h"
#include "Picture.h"

#include <string>
#include <utility>
#include <vector>

namespace widefov
{
// The metadata of these pictures for viewers of panoramas.
PanoramaInfo DescribePanorama(const Options& options);

// Names and bytes of the files of one --output, from the pictures that were drawn: one, or one
// of each eye; none where there are none.
std::vector<std::pair<std::string, std::vector<unsigned char>>> EncodeFiles(
  const Options& options, const std::string& output, const std::vector<Picture>& drawn);
}

#endif
