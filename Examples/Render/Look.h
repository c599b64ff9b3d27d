// SPDX-License-Identifier: BSD-3-Clause
// How data are to look.
#ifndef WideFoVLook_h
#define WideFoVLook_h

#include <array>
#include <optional>
#include <string>

namespace widefov
{
using Vector3 = std::array<double, 3>;

struct Look
{
  std::string ColorBy; // NAME or NAME:COMPONENT; empty: the data's own scalars
  std::string ColorMap = "cool-warm";
  std::optional<std::array<double, 2>> Range; // none: that of the data
  std::string Representation = "surface";     // surface-with-edges, wireframe, points
  double LineWidth = 1;                       // pixels
  double PointSize = 3;                       // pixels
  bool LinesAsTubes = false;
  bool PointsAsSpheres = false;
  bool ScalarBar = false;
  std::string Vectors;     // array drawn as arrows instead of the surface
  std::string StreamLines; // array drawn as stream tubes instead of the surface
};
}

#endif
