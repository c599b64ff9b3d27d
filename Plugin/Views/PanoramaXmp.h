// SPDX-License-Identifier: BSD-3-Clause
// The photo sphere metadata by which viewers recognise an equirectangular picture:
// XMP of the name space http://ns.google.com/photos/1.0/panorama/.
#ifndef WideFoVPluginPanoramaXmp_h
#define WideFoVPluginPanoramaXmp_h

#include <string>
#include <vector>

namespace wfvplugin
{
struct Panorama
{
  int Width = 0; // pixels
  int Height = 0;
  double HorizontalFov = 360; // degrees
  double VerticalFov = 180;
  double Pitch = 0; // degrees of the picture's middle above the horizon
};

// The packet: a smaller field of view is a crop out of the middle of the whole sphere.
std::string PanoramaXmp(const Panorama& panorama);

// Inserts a packet into the bytes of a file: the iTXt chunk "XML:com.adobe.xmp" of a PNG, the
// segment APP1 of a JPEG. False, and no change, where the bytes are not of such a file.
bool InsertXmpInPng(std::vector<unsigned char>& file, const std::string& xmp);
bool InsertXmpInJpeg(std::vector<unsigned char>& file, const std::string& xmp);
}

#endif
