// SPDX-License-Identifier: BSD-3-Clause
// The scenes of the benchmark: built-in ones, and the air flow in an office.
#ifndef WideFoVBenchScenes_h
#define WideFoVBenchScenes_h

#include "Options/Options.h"
#include "RayCaster.h"
#include "Scenes/Scene.h"

#include <string>
#include <vector>

namespace wfv
{
namespace bench
{
struct BenchScene
{
  std::string Name;
  widefov::Scene Scene;    // every surface of triangles alone, one cell each
  widefov::Options Camera; // eye, direction, up and look; the rest is the run's
  long long Triangles = 0;
  std::vector<vtkIdType> FirstCells; // where the cells of each prop begin, numbered through
};

std::vector<std::string> BenchSceneNames();

// Those and what is drawn only where it is asked for.
std::vector<std::string> AllSceneNames();

// Throws a Failure with ExitFailed where the data are not there.
BenchScene LoadBenchScene(const std::string& name, const std::string& dataFolder);

// All triangles in view coordinates.
reference::TriangleSoup SoupOf(const BenchScene& scene, const reference::Pose& worldToView);
}
}

#endif
