// SPDX-License-Identifier: BSD-3-Clause
#include "Frame/Technique.h"

#include "Compat/Reports.h"

#include "vtkObject.h"

#include <algorithm>

namespace wfv
{
const std::vector<TechniqueEntry>& Techniques()
{
  static const std::vector<TechniqueEntry> all{
    { TechniqueAuto, "auto", "Automatic",
      "for each part of the scene the cheapest that keeps the tolerance, under 0.05 pixels as "
      "Exact" },
    { TechniqueExact, "exact", "Exact", "every triangle by the ray of each pixel" },
    { TechniquePreClip, "preclip", "Pre-clip",
      "clipped at the discontinuities, in pieces within the tolerance" },
    { TechniqueVertex, "vertex", "Vertices only",
      "projected at the corners and not clipped, for comparison" },
  };
  return all;
}

int FindTechnique(const std::string& name)
{
  for (const TechniqueEntry& technique : Techniques())
  {
    if (technique.Name == name)
    {
      return technique.Number;
    }
  }
  return -1;
}

int TechniqueOf(int number)
{
  if (number != TechniqueTessellate)
  {
    return std::clamp<int>(number, TechniqueAuto, TechniqueVertex);
  }
  if (IsNews("technique tessellate"))
  {
    vtkGenericWarningMacro(
      "The technique tessellate is called auto; the old name goes with the next release.");
  }
  return TechniqueAuto;
}
}
