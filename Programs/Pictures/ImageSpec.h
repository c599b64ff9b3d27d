// SPDX-License-Identifier: BSD-3-Clause
// What OpenImageIO is told of a picture.
#ifndef WideFoVImageSpec_h
#define WideFoVImageSpec_h

#include "Picture.h"

#include <OpenImageIO/imageio.h>

namespace widefov
{
// Colour and float channels: size, channels, what viewers want to know, compression.
OIIO::ImageSpec PictureSpec(
  int width, int height, const std::string& path, const PanoramaInfo& info);
OIIO::ImageSpec FloatSpec(
  int width, int height, const std::vector<std::string>& channels, const PanoramaInfo& info);

// A PNG's panorama metadata, which OpenImageIO does not write: the chunk that goes where the
// header ends, so many bytes from the beginning; empty for other files.
std::vector<unsigned char> PngPanorama(
  int width, int height, const std::string& path, const PanoramaInfo& info);
}

#endif
