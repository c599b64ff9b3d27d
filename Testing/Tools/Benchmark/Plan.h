// SPDX-License-Identifier: BSD-3-Clause
// Which runs a benchmark consists of.
#ifndef WideFoVPlan_h
#define WideFoVPlan_h

#include "Record.h"

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace wfv
{
namespace bench
{
struct PlanRequest
{
  std::array<int, 2> Size{ { 2048, 1024 } };
  bool Quick = false;
  std::vector<std::string> Methods;           // empty: all
  bench::Motion Motion;                       // of every camera; only still there is a floor
  std::string Projection = "equirectangular"; // of the techniques, at its widest
  double Tolerance = 0;                       // of auto, pixels; 0: several
  std::shared_ptr<const DirectionMap> Map;    // of that projection, drawn in its stead
  int Samples = 0; // a pixel, of every window; 0: no multisampling; more than 1:
                   // there is a cubemap-ss
};

std::vector<std::string> MethodNames();

// What the techniques show of a projection, at its widest, as a direction map.
std::shared_ptr<const DirectionMap> MakeDirectionMap(
  const std::string& projection, const std::array<int, 2>& size);

// What the methods draw, at its widest; of the perspective, as the method of that name does.
std::vector<std::string> ProjectionNames();

// Pixels a cube face needs so that its centre is as dense as an equirectangular picture
// of that width: the circle over pi.
int EqualDensity(int width);

// What the cubemap needs to be as smooth as several samples: twice as many pixels in both
// directions, of its faces and of the picture. Its faces have no samples.
const char* const SmoothCubeMap = "cubemap-ss";

// The runs of one scene. `camera` gives eye, direction and look.
std::vector<Run> MakePlan(const PlanRequest& request, const widefov::Options& camera);

// The rows of the paper's table 1: perspective 120, equirectangular 120, 180, 270 and 360,
// hammer 360, each without and with 4 samples.
std::vector<Run> MakeTable1(const PlanRequest& request, const widefov::Options& camera);
}
}

#endif
