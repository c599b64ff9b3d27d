// SPDX-License-Identifier: BSD-3-Clause
// Pictures as files, through OpenImageIO.
#ifndef WideFoVImageOutput_h
#define WideFoVImageOutput_h

#include "Picture.h"

#include <string>
#include <vector>

namespace widefov
{
// The bytes of the file that the ending of `path` asks for. Equirectangular JPEG, TIFF
// and PNG carry GPano metadata, EXR of the whole sphere the attribute envmap. EXR holds
// the displayed values over 255, not linear light. JPEG and PNG of two eyes carry the
// metadata of spherical video. Throw a Failure with ExitFailed.
std::vector<unsigned char> EncodePicture(
  const Picture& picture, const std::string& path, const PanoramaInfo& info);

// An EXR file of two parts with the names, and views, "left" and "right".
std::vector<unsigned char> EncodeMultiView(
  const std::vector<Picture>& eyes, const PanoramaInfo& info);

// A VR180 photo: the picture of the left eye with that of the right one in its metadata.
std::vector<unsigned char> EncodeVr180Photo(
  const std::vector<Picture>& eyes, const PanoramaInfo& info);

std::vector<unsigned char> EncodeFloats(const FloatPicture& picture, const PanoramaInfo& info);
}

#endif
