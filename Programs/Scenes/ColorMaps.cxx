// SPDX-License-Identifier: BSD-3-Clause
#include "ColorMaps.h"

#include <vtkColorTransferFunction.h>
#include <vtkNew.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace widefov
{
namespace
{
struct Stop
{
  double Position; // 0 to 1, or metres in the relief map
  double Red, Green, Blue;
};

struct Definition
{
  std::string Name;
  bool Diverging; // blended in a perceptual space through its pale middle
  std::vector<Stop> Stops;
};

const std::vector<Definition>& Definitions()
{
  static const std::vector<Definition> all{
    { "cool-warm", true, { { 0, 0.23, 0.30, 0.75 }, { 1, 0.71, 0.02, 0.15 } } },
    { "viridis", false,
      { { 0, 0.267, 0.005, 0.329 }, { 0.125, 0.278, 0.175, 0.483 }, { 0.25, 0.230, 0.322, 0.546 },
        { 0.375, 0.173, 0.449, 0.558 }, { 0.5, 0.128, 0.567, 0.551 },
        { 0.625, 0.158, 0.684, 0.502 }, { 0.75, 0.369, 0.789, 0.383 },
        { 0.875, 0.678, 0.864, 0.190 }, { 1, 0.993, 0.906, 0.144 } } },
    { "rainbow", false,
      { { 0, 0, 0, 1 }, { 0.25, 0, 1, 1 }, { 0.5, 0, 1, 0 }, { 0.75, 1, 1, 0 }, { 1, 1, 0, 0 } } },
    { "black-body", false,
      { { 0, 0, 0, 0 }, { 0.4, 0.9, 0, 0 }, { 0.8, 0.9, 0.9, 0 }, { 1, 1, 1, 1 } } },
    { "gray", false, { { 0, 0, 0, 0 }, { 1, 1, 1, 1 } } },
  };
  return all;
}

void SetComponent(vtkScalarsToColors* map, int component)
{
  if (component < 0)
  {
    map->SetVectorModeToMagnitude();
    return;
  }
  map->SetVectorModeToComponent();
  map->SetVectorComponent(component);
}
}

const std::vector<std::string>& ColorMapNames()
{
  static const std::vector<std::string> names = [] {
    std::vector<std::string> list;
    for (const Definition& d : Definitions())
    {
      list.push_back(d.Name);
    }
    return list;
  }();
  return names;
}

vtkSmartPointer<vtkScalarsToColors> MakeColorMap(
  const std::string& name, double low, double high, int component)
{
  vtkNew<vtkColorTransferFunction> map;
  if (!(high > low))
  {
    high = low + std::max(1e-6 * std::abs(low), 1e-30); // a constant array has one colour
  }
  for (const Definition& d : Definitions())
  {
    if (d.Name != name)
    {
      continue;
    }
    if (d.Diverging)
    {
      map->SetColorSpaceToDiverging();
    }
    for (const Stop& s : d.Stops)
    {
      map->AddRGBPoint(low + s.Position * (high - low), s.Red, s.Green, s.Blue);
    }
  }
  map->SetNanColor(0.5, 0.5, 0.5);
  SetComponent(map, component);
  return map;
}

vtkSmartPointer<vtkScalarsToColors> MakeReliefColorMap()
{
  // metres above the sea; two stops a hand's breadth apart make the coast sharp
  static const std::vector<Stop> stops{ { -8000, 0.04, 0.09, 0.28 }, { -4000, 0.10, 0.25, 0.52 },
    { -1500, 0.22, 0.45, 0.70 }, { -200, 0.50, 0.72, 0.86 }, { -0.1, 0.70, 0.86, 0.93 },
    { 0, 0.24, 0.46, 0.22 }, { 300, 0.45, 0.60, 0.30 }, { 1000, 0.78, 0.72, 0.45 },
    { 2500, 0.60, 0.42, 0.25 }, { 4500, 0.80, 0.76, 0.72 }, { 6500, 1, 1, 1 } };
  vtkNew<vtkColorTransferFunction> map;
  for (const Stop& s : stops)
  {
    map->AddRGBPoint(s.Position, s.Red, s.Green, s.Blue);
  }
  map->SetNanColor(0.5, 0.5, 0.5);
  return map;
}
}
