// SPDX-License-Identifier: BSD-3-Clause
#include "Frame/Technique.h"

namespace wfv
{
const std::vector<TechniqueEntry>& Techniques()
{
  static const std::vector<TechniqueEntry> all{
    { "auto", "Automatic",
      "for each part of the scene the cheapest that keeps the tolerance, under 0.05 pixels as "
      "Exact" },
    { "exact", "Exact", "every triangle by the ray of each pixel" },
    { "tessellate", "Tessellate", "triangles cut into pieces within the tolerance, these by rays" },
    { "preclip", "Pre-clip", "clipped at the discontinuities, in pieces within the tolerance" },
    { "vertex", "Vertices only", "projected at the corners and not clipped, for comparison" },
  };
  return all;
}

int FindTechnique(const std::string& name)
{
  const std::vector<TechniqueEntry>& all = Techniques();
  for (std::size_t i = 0; i < all.size(); i++)
  {
    if (all[i].Name == name)
    {
      return static_cast<int>(i);
    }
  }
  return -1;
}
}
