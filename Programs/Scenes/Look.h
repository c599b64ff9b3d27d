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
  bool Colors = true;  // of files, where ColorBy is empty: of the first scalar array
  std::string ColorMap = "cool-warm";
  std::optional<std::array<double, 2>> Range; // none: that of the data
  bool OfSeries = false;                      // one time step of several
  std::string UsualArray; // where ColorBy is empty: array that an earlier step was coloured by
  std::string Representation = "surface"; // surface-with-edges, wireframe, points
  double LineWidth = 1;                   // pixels
  double PointSize = 3;                   // pixels
  bool LinesAsTubes = false;
  bool PointsAsSpheres = false;
  bool Smooth = true; // normals for surfaces of files that have none
  bool ScalarBar = false;
  bool UsualBar = true;     // a bar of the colours of files that nobody chose
  std::string Vectors;      // array drawn as arrows
  std::string StreamLines;  // array drawn as stream tubes
  bool Surface = true;      // under these
  bool Volume = false;      // what fills space as a volume
  double VolumeOpacity = 1; // times as much light is taken on the same way
  bool UsualVolume = true;  // images of files as volumes, where nobody says anything
};
}

#endif
