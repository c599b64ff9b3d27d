// SPDX-License-Identifier: BSD-3-Clause
// The photo sphere metadata by which viewers recognise an equirectangular picture:
// XMP of the name space http://ns.google.com/photos/1.0/panorama/.
#ifndef WideFoVMetadataPanoramaXmp_h
#define WideFoVMetadataPanoramaXmp_h

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
  double Pitch = 0; // degrees of the picture's middle above the horizon
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

// An XMP packet of one description: name spaces and attributes.
std::string XmpPacket(const std::string& description);

// Both: the packet of a panorama.
std::string PanoramaXmp(const Panorama& panorama);
}

#endif
