// SPDX-License-Identifier: BSD-3-Clause
// Colour maps by name.
#ifndef WideFoVColorMaps_h
#define WideFoVColorMaps_h

#include <vtkScalarsToColors.h>
#include <vtkSmartPointer.h>

#include <string>
#include <vector>

namespace widefov
{
const std::vector<std::string>& ColorMapNames();

// The map of that name over [low, high] (widened a little where they are equal), of
// one component of the array, or of its magnitude (component -1). The name must be one
// of ColorMapNames().
vtkSmartPointer<vtkScalarsToColors> MakeColorMap(
  const std::string& name, double low, double high, int component);

// Sea depths in blue, land in green, brown and white, the border exactly at 0 metres.
vtkSmartPointer<vtkScalarsToColors> MakeReliefColorMap();
}

#endif
