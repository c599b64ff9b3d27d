// SPDX-License-Identifier: BSD-3-Clause
// Table of a projector: what each pixel shows, and how bright. All calibrations become tables.
#ifndef WideFoVDisplaysTable_h
#define WideFoVDisplaysTable_h

#include "Calibration.h"

#include <functional>

namespace wfv::displays
{
struct Table
{
  int Width = 0; // pixels
  int Height = 0;
  Shows What = Shows::Direction; // directions or points
  std::vector<vec3> Values;      // the bottom row first; NaN: the pixel shows nothing
  std::vector<float> Brightness; // linear light, 0 to 1, a number a pixel
  std::vector<float> Lift;       // linear light that is added; empty: none
  std::optional<vec3> Center;    // of points: where all rays of the projector come from, metres

  std::size_t Count() const { return static_cast<std::size_t>(this->Width) * this->Height; }
};

// The unit direction of a place u, v (0 to 1) of the picture that a mesh refers to; NaN where that
// picture has none.
using Content = std::function<vec3(vec2 uv)>;

// The table of a projector of this size, pixels. Values are those of the calibration at the centre
// of each pixel, by its own interpolation: linear in the triangles of a mesh, bilinear between
// pixels. `content` is asked where the calibration refers to a picture and does not say which.
// gamma: of the projector. Throws a FileError where `content` is asked and missing, or where no
// pixel shows anything.
Table MakeTable(const Calibration& calibration, int width, int height,
  const Content& content = nullptr, double gamma = 2.2);

// Unit directions from the eye, three floats a pixel, the bottom row first, as wfv::DirectionMap
// takes them; 0, 0, 0 where a pixel shows nothing. The eye matters to points alone; metres, room.
std::vector<float> DirectionsFrom(const Table& table, const vec3& eye);

// Values and brightness of a mesh at the centres of pixels. Brightness is 0 where nothing is shown.
void DrawMesh(const WarpMesh& mesh, Raster& values, std::vector<float>& brightness);

// Values at the centres of width x height pixels, bilinear between those of the raster; NaN where
// one of the four is.
Raster Resampled(const Raster& raster, int width, int height);

// The same of a mask, for one pixel; x and y from 0 to 1 over the picture.
double MaskAt(const Mask& mask, double x, double y);

// Multiplies the brightness by a mask of the same size, whose stored values are to the power of
// 1 / gamma. Throws a FileError where the sizes differ.
void ApplyMask(const std::string& path, const Mask& mask, double gamma, Table& table);

// A value of a picture, 0 to 1, as the projector has to get it: brightness and lift are applied in
// linear light.
double Lit(double value, double brightness, double lift, double gamma);
}

#endif
