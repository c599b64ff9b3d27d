// SPDX-License-Identifier: BSD-3-Clause
// The metadata by which players recognise films of all directions: Spherical Video, version 1 (XML)
// and version 2 (boxes), https://github.com/google/spatial-media/tree/master/docs.
#ifndef WideFoVSphericalTags_h
#define WideFoVSphericalTags_h

#include "Mp4Boxes.h"
#include "Options/Options.h"

#include <array>
#include <string>

namespace widefov
{
struct SphericalInfo
{
  bool Equirectangular = false;
  std::string StereoMode; // "left-right", "top-bottom": two eyes in a frame; empty: one
  int Width = 0;          // of a frame, with both eyes
  int Height = 0;
  double HorizontalFov = 360; // degrees, around the middle, of `Whole`
  double VerticalFov = 180;
  std::array<int, 2> Eye{ { 0, 0 } };    // pixels of one eye's part of a frame
  std::array<int, 2> Whole{ { 0, 0 } };  // of the larger picture that it is a part of, or the same
  std::array<int, 2> Before{ { 0, 0 } }; // pixels of that left of it and above it
  double Pitch = 0;                      // degrees of the middle above the horizon

  // Players are told something.
  bool HasTags() const { return this->Equirectangular || !this->StereoMode.empty(); }
};

// Of a film with these options. Eyes that are squeezed into one picture count: of an
// equirectangular map every shape is known.
SphericalInfo DescribeFilm(const Options& options);

// Version 1; empty where the film is not equirectangular.
std::string SphericalXml(const SphericalInfo& info);

// The layout of the eyes as Matroska calls it; empty for one.
std::string MatroskaStereoMode(const SphericalInfo& info);

// Adds both versions to the movie box. Throws a Failure with ExitFailed where it has no video.
void TagMovie(Mp4Box& movie, const SphericalInfo& info);
}

#endif
