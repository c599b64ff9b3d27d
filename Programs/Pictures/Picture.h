// SPDX-License-Identifier: BSD-3-Clause
// Pictures in memory.
#ifndef WideFoVPicture_h
#define WideFoVPicture_h

#include <array>
#include <string>
#include <vector>

namespace widefov
{
// Rows from the top.
struct Picture
{
  int Width = 0;
  int Height = 0;
  std::vector<unsigned char> Rgb;
};

struct FloatPicture
{
  int Width = 0;
  int Height = 0;
  std::vector<std::string> Channels;
  std::vector<float> Values; // interleaved
};

// Metadata for viewers of panoramas.
struct PanoramaInfo
{
  bool Equirectangular = false;
  double HorizontalFov = 360;            // degrees
  double VerticalFov = 180;              // degrees
  double Pitch = 0;                      // degrees of the middle above the horizon
  std::array<int, 2> Whole{ { 0, 0 } };  // pixels that have these fields of view; 0: the picture's
  std::array<int, 2> Before{ { 0, 0 } }; // of these, left of the picture and above it
  std::string Description;               // of a frame: the options of its film; empty: none
  std::string StereoMode; // "left-right", "top-bottom": two pictures in one; empty: one
};
}

#endif
