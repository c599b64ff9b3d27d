// SPDX-License-Identifier: BSD-3-Clause
// The built-in scenes, by name.
#ifndef WideFoVScenes_h
#define WideFoVScenes_h

#include "Scene.h"

#include <string>
#include <vector>

namespace widefov
{
struct SceneDefinition
{
  std::string Name;
  std::string Title; // for people
  Scene (*Make)();
};

const std::vector<SceneDefinition>& SceneDefinitions();
std::vector<std::string> SceneNames();

// The scene of that name, which must be one of SceneNames(). Throws a Failure with
// ExitFailed where its data are not installed.
Scene MakeScene(const std::string& name);

// One file a scene, or a family of them.
Scene MakeCornell();     // 34 triangles: a closed box with two blocks and a lamp
Scene MakeRoom();        // 12 triangles round the eye
Scene MakeSphere();      // 327,680 triangles round the eye, every edge under a degree
Scene MakeGlobe();       // latitude-longitude sphere in colours, seen from its centre
Scene MakeAtrium();      // 225,839 triangles: a hall with columns, arches and drapes
Scene MakeFlow();        // stream tubes of a vortical flow all round the eye
Scene MakeFlowLarge();   // the same with over 1,000,000 triangles
Scene MakeBalls();       // 127 balls of 8,064 triangles each all round, a prop a ball
Scene MakeBallsApart();  // as many, none of which meets the seam or a pole; for the benchmark
Scene MakeVectorCloud(); // arrows on a regular grid round the eye
Scene MakeWinds();       // NOAA relief seen from the centre of the Earth, with winds

// A scene of one mesh that carries its colours in the point array "Colors".
Scene ColoredScene(const std::string& label, vtkPolyData* mesh);

// Latitude and longitude (degrees) to the unit sphere as seen from its centre by a
// camera that looks along -z: east is to the right, north is up. The sphere is thus
// the mirror image of a globe seen from outside.
Vector3 DirectionOf(double longitude, double latitude);
}

#endif
