// SPDX-License-Identifier: BSD-3-Clause
// The photo sphere metadata by which viewers recognise an equirectangular picture:
// XMP of the name space http://ns.google.com/photos/1.0/panorama/.
#ifndef WideFoVMetadataPanoramaXmp_h
#define WideFoVMetadataPanoramaXmp_h

#include <array>
#include <string>
#include <vector>

namespace wfvxmp
{
struct Panorama
{
  int Width = 0; // pixels
  int Height = 0;
  double HorizontalFov = 360; // degrees
  double VerticalFov = 180;
  double Pitch = 0;                      // degrees of the middle of these above the horizon
  std::array<int, 2> Whole{ { 0, 0 } };  // pixels that have these fields of view; 0: the picture's
  std::array<int, 2> Before{ { 0, 0 } }; // of these, left of the picture and above it
};

struct Field
{
  std::string Name;
  std::string Value;
};

// A smaller field of view is a crop out of the middle of the whole sphere at the same density.
std::vector<Field> PanoramaFields(const Panorama& panorama);

// The fields as attributes of a description, with their name space.
std::string PanoramaText(const Panorama& panorama);

// Those of the fields that spherical video has as well: which part of the whole sphere is shown.
std::vector<Field> CroppedFields(const Panorama& panorama);

// An XMP packet of one description: name spaces and attributes.
std::string XmpPacket(const std::string& description);

// Both: the packet of a panorama.
std::string PanoramaXmp(const Panorama& panorama);

// The metadata of spherical video (version 1, http://ns.google.com/videos/1.0/spherical/) as an XMP
// packet, for a picture of two eyes. Its mode is "left-right" or "top-bottom", `eye` is one of the
// two. Such metadata know no pitch.
std::string SphericalXmp(const Panorama& eye, const std::string& stereoMode);
}

#endif
