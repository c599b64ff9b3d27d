// SPDX-License-Identifier: BSD-3-Clause
// Primitives that are hard to draw, by what makes them so.
#ifndef WideFoVStressCases_h
#define WideFoVStressCases_h

#include "vtkWideFoVAbi.h"

#include "Random.h"

#include <vtkSmartPointer.h>

#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkPolyData;
VTK_ABI_NAMESPACE_END

namespace wfv
{
namespace stress
{
// What one picture shows. The eye is where `Eye` says; the clip spheres hold everything
// that is meant to be seen.
struct Subject
{
  vtkSmartPointer<vtkPolyData> Mesh; // triangles alone
  vec3 Eye{ 0 };
  double Near = 0.05;
  double Far = 50;
};

struct Case
{
  std::string Name;
  std::string Title; // for people
  int Primitives;    // of one picture: few where each covers much of it
  double Share;      // of all primitives of a run
  bool Upright;      // the view stays along the axes: places are exact there
  bool Closed;       // a mesh round the eye that every direction meets exactly once
  Subject (*Make)(Random& random, int primitives);
};

const std::vector<Case>& Cases();
std::vector<std::string> CaseNames();
const Case* FindCase(const std::string& name);

// One file a family of them.
Subject MakeRandom(Random& random, int primitives);      // all sizes
Subject MakeSmall(Random& random, int primitives);       // a few pixels each
Subject MakeLarge(Random& random, int primitives);       // up to round the eye
Subject MakeNeedles(Random& random, int primitives);     // long, a pixel wide or less
Subject MakeSlivers(Random& random, int primitives);     // three points nearly in a line
Subject MakeZeroArea(Random& random, int primitives);    // half of them without area
Subject MakeSeams(Random& random, int primitives);       // vertices on the seam behind
Subject MakePoles(Random& random, int primitives);       // vertices on poles and antipode
Subject MakeEye(Random& random, int primitives);         // vertices, edges, planes at the eye
Subject MakeScales(Random& random, int primitives);      // 1e-6 to 1e8
Subject MakeOffsets(Random& random, int primitives);     // 1e5 from the origin
Subject MakeSignedZeros(Random& random, int primitives); // 0 and -0 in every place
Subject MakeDenormals(Random& random, int primitives);   // numbers below 1.2e-38
Subject MakeClosed(Random& random, int primitives);
Subject MakeClosedThin(Random& random, int primitives);
Subject MakeClosedScales(Random& random, int primitives);
Subject MakeClosedOffsets(Random& random, int primitives);
}
}

#endif
