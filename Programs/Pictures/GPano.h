// SPDX-License-Identifier: BSD-3-Clause
// The photo sphere metadata by which viewers recognise an equirectangular picture:
// XMP of the name space http://ns.google.com/photos/1.0/panorama/.
#ifndef WideFoVGPano_h
#define WideFoVGPano_h

#include "PanoramaXmp.h"
#include "Picture.h"
#include "XmpInFiles.h"

#include <string>
#include <vector>

namespace widefov
{
// For a picture of that many pixels; a smaller field of view is a crop out of the middle
// of the whole sphere at the same density.
std::vector<wfvxmp::Field> GPanoFields(int width, int height, const PanoramaInfo& info);

// The fields as attributes of an XMP description, with their name space.
std::string GPanoText(int width, int height, const PanoramaInfo& info);

// The same as an XMP packet.
std::string GPanoXmp(int width, int height, const PanoramaInfo& info);

// Inserts a chunk, where it is not empty, into the bytes of a PNG file, behind the header. Throws
// a Failure with ExitFailed where these are no PNG.
void InsertInPng(std::vector<unsigned char>& png, const std::vector<unsigned char>& chunk);

// Those of the fields that spherical video has as well, for one eye of that many pixels: which part
// of the whole sphere is shown.
std::vector<wfvxmp::Field> CroppedFields(int width, int height, const PanoramaInfo& info);

// The metadata of spherical video (version 1, http://ns.google.com/videos/1.0/spherical/) as an
// XMP packet, for a picture of two eyes: of that many pixels, both together.
std::string SphericalXmp(int width, int height, const PanoramaInfo& info);
}

#endif
