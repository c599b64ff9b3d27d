// SPDX-License-Identifier: BSD-3-Clause
#include "Cases.h"

namespace wfv
{
namespace stress
{
const std::vector<Case>& Cases()
{
  static const std::vector<Case> all{
    { "random", "all sizes", 4000, 0.16, false, false, MakeRandom },
    { "small", "a few pixels each", 10000, 0.30, false, false, MakeSmall },
    { "large", "up to round the eye", 60, 0.002, false, false, MakeLarge },
    { "needles", "long, a pixel wide or less", 500, 0.02, false, false, MakeNeedles },
    { "slivers", "three points nearly in a line", 1000, 0.04, false, false, MakeSlivers },
    { "zero-area", "half of them without area", 4000, 0.08, false, false, MakeZeroArea },
    { "seams", "vertices on the seam and next to it", 1000, 0.04, true, false, MakeSeams },
    { "poles", "vertices on poles and antipode", 1000, 0.04, true, false, MakePoles },
    { "eye", "vertices, edges and planes at the eye", 200, 0.008, true, false, MakeEye },
    { "scales", "scales from 1e-6 to 1e8", 4000, 0.08, false, false, MakeScales },
    { "offsets", "1e5 from the origin", 2000, 0.04, false, false, MakeOffsets },
    { "signed-zeros", "0 and -0 in every place", 40, 0.002, true, false, MakeSignedZeros },
    { "denormals", "numbers below 1.2e-38", 2000, 0.04, true, false, MakeDenormals },
    { "closed", "closed meshes round the eye", 400, 0.05, false, true, MakeClosed },
    { "closed-upright", "the same, vertices on poles, seam and antipode", 400, 0.03, true, true,
      MakeClosed },
    { "closed-thin", "the same, very thin triangles", 400, 0.03, false, true, MakeClosedThin },
    { "closed-scales", "the same at scales from 1e-6 to 1e8", 400, 0.016, false, true,
      MakeClosedScales },
    { "closed-offsets", "the same 1e5 from the origin", 400, 0.016, false, true,
      MakeClosedOffsets },
  };
  return all;
}

std::vector<std::string> CaseNames()
{
  std::vector<std::string> names;
  for (const Case& c : Cases())
  {
    names.push_back(c.Name);
  }
  return names;
}

const Case* FindCase(const std::string& name)
{
  for (const Case& c : Cases())
  {
    if (c.Name == name)
    {
      return &c;
    }
  }
  return nullptr;
}
}
}
