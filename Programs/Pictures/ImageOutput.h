// SPDX-License-Identifier: BSD-3-Clause
// Pictures as files, through OpenImageIO.
#ifndef WideFoVImageOutput_h
#define WideFoVImageOutput_h

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

// What a viewer of panoramas wants to know.
struct PanoramaInfo
{
  bool Equirectangular = false;
  double HorizontalFov = 360;            // degrees
  double VerticalFov = 180;              // degrees
  double Pitch = 0;                      // degrees of the middle above the horizon
  std::array<int, 2> Whole{ { 0, 0 } };  // pixels that have these fields of view; 0: the picture's
  std::array<int, 2> Before{ { 0, 0 } }; // of these, left of the picture and above it
  std::string StereoMode; // "left-right", "top-bottom": two pictures in one; empty: one
};

// Throw a Failure with ExitUsage where the ending is none that can be written.
void CheckPictureName(const std::string& path);
void CheckAovName(const std::string& path);

// True where a file of this name can keep several views.
bool IsMultiViewName(const std::string& path);

// True where the name is that of a VR180 photo, NAME.vr.jpg.
bool IsVr180Photo(const std::string& path);

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
