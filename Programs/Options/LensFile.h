// SPDX-License-Identifier: BSD-3-Clause
// Reads what a camera's calibration has found: OpenCV's and ROS's YAML, COLMAP's cameras.txt.
#ifndef WideFoVLensFile_h
#define WideFoVLensFile_h

#include "Projections/ProjectionMath.h"

#include <array>
#include <optional>
#include <string>

namespace widefov
{
// Lenses that no round map draws, as direction maps.
enum class UnevenKind
{
  OpenCv,      // Brown-Conrady with decentering and rational coefficients
  Fov,         // COLMAP's FOV: the radius is atan(2 t tan(w / 2)) / w; Coefficients[0] is w
  PrismFisheye // COLMAP's THIN_PRISM_FISHEYE; Coefficients are k1, k2, p1, p2, k3, k4, sx1, sy1
};

// How the angle from the axis becomes a radius.
enum class LensModel
{
  Fisheye,     // OpenCV's fisheye: a polynomial of the angle
  BrownConrady // a polynomial of its tangent, and what is not round
};

// A camera as it was calibrated; pixels.
struct CalibratedLens
{
  std::optional<LensModel> Model; // none: the file does not say
  UnevenKind Kind = UnevenKind::OpenCv;
  wfv::vec2 Size{ 0, 0 };  // of the picture
  wfv::vec2 Focal{ 0, 0 }; // focal lengths along x and y
  wfv::vec2 Axis{ 0, 0 };  // principal point, from the upper left corner of the first pixel
  double End = 0;          // tangent of the angle from the axis up to which it is drawn
  std::array<double, 8>
    Coefficients{}; // OpenCV's order: k1, k2, p1, p2, k3 .. k6; fisheye: k1 .. k4
};

// Of FILE, or of FILE#ID where the file has several cameras. Throws a Failure: with ExitFailed
// where there is no such file, with ExitUsage where it says nothing sensible.
CalibratedLens ReadLensFile(const std::string& path);
}

#endif
