// SPDX-License-Identifier: BSD-3-Clause
#include "Scenes.h"

#include "Text/Angles.h"
#include "Text/Messages.h"

#include <cmath>

namespace widefov
{
const std::vector<SceneDefinition>& SceneDefinitions()
{
  static const std::vector<SceneDefinition> all{
    { "cornell", "closed box with two blocks and a lamp, 34 triangles", MakeCornell },
    { "atrium", "hall with columns, arches and drapes, 225,839 triangles", MakeAtrium },
    { "room", "12 triangles round the eye", MakeRoom },
    { "globe", "latitude-longitude sphere in colours, seen from its centre", MakeGlobe },
    { "winds", "NOAA relief and January winds, seen from the centre of the Earth", MakeWinds },
    { "flow", "stream tubes of a vortical flow all round the eye", MakeFlow },
    { "flow-large", "the same flow with over 1,000,000 triangles", MakeFlowLarge },
    { "vector-cloud", "arrows on a regular grid round the eye", MakeVectorCloud },
    { "balls", "127 props of 8,064 triangles each, evenly round the eye", MakeBalls },
    { "sphere", "327,680 triangles round the eye, every edge under a degree", MakeSphere },
  };
  return all;
}

std::vector<std::string> SceneNames()
{
  std::vector<std::string> names;
  for (const SceneDefinition& d : SceneDefinitions())
  {
    names.push_back(d.Name);
  }
  return names;
}

Scene MakeScene(const std::string& name)
{
  for (const SceneDefinition& d : SceneDefinitions())
  {
    if (d.Name == name)
    {
      return d.Make();
    }
  }
  FailUsage("there is no scene '" + name + "'; --list-scenes prints the names");
}

Scene ColoredScene(const std::string& label, vtkPolyData* mesh)
{
  SceneProp prop;
  prop.Surface = mesh;
  prop.Source = mesh;
  prop.Label = label;
  prop.Array = "Colors";
  prop.Direct = true;
  Scene scene;
  scene.Props.push_back(prop);
  return scene;
}

Vector3 DirectionOf(double longitude, double latitude)
{
  if (std::abs(latitude) >= 90)
  {
    return { { 0, latitude > 0 ? 1. : -1., 0 } }; // one point, whatever the longitude
  }
  const double turned = std::remainder(longitude, 360.);
  const double lambda = (turned <= -180 ? 180 : turned) * Degree; // so is the date line
  const double phi = latitude * Degree;
  return { { std::cos(phi) * std::sin(lambda), std::sin(phi), -std::cos(phi) * std::cos(lambda) } };
}
}
