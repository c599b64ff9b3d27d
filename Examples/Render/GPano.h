// SPDX-License-Identifier: BSD-3-Clause
// The photo sphere metadata by which viewers recognise an equirectangular picture:
// XMP of the name space http://ns.google.com/photos/1.0/panorama/.
#ifndef WideFoVGPano_h
#define WideFoVGPano_h

#include "ImageOutput.h"

#include <string>
#include <vector>

namespace widefov
{
struct GPanoField
{
  std::string Name;
  std::string Value;
};

// For a picture of that many pixels; a smaller field of view is a crop out of the middle
// of the whole sphere at the same density.
std::vector<GPanoField> GPanoFields(int width, int height, const PanoramaInfo& info);

// An XMP packet of one description: name spaces and attributes.
std::string XmpPacket(const std::string& description);

// The fields as such attributes, with their name space.
std::string GPanoText(int width, int height, const PanoramaInfo& info);

// The same as an XMP packet.
std::string GPanoXmp(int width, int height, const PanoramaInfo& info);

// The same as a PNG's chunk iTXt "XML:com.adobe.xmp".
std::vector<unsigned char> PngXmpChunk(const std::string& xmp);

// Bytes of a PNG's signature and of its header, behind which chunks may be inserted.
constexpr std::size_t PngHeaderEnd = 8 + 4 + 4 + 13 + 4;

// Inserts a chunk, where it is not empty, into the bytes of a PNG file, behind the header. Throws
// a Failure with ExitFailed where these are no PNG.
void InsertInPng(std::vector<unsigned char>& png, const std::vector<unsigned char>& chunk);

// The metadata of spherical video (version 1, http://ns.google.com/videos/1.0/spherical/) as an
// XMP packet, for a picture of two eyes: of that many pixels, both together.
std::string SphericalXmp(int width, int height, const PanoramaInfo& info);
}

#endif
