// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWideFoVPointShaders.h"

#include "WideFoVGlsl.h"

namespace wfv
{
namespace point
{
using namespace shader;

bool Draws(const Request& r)
{
  // behind a flat rim even a small one would show, as if it were on it
  return r.Kind == Primitive::Points && (r.WidePoints || r.Projection->FlatRim) &&
    r.Stage != vtkWideFoVShaderBuilder::Variant::Plain;
}

std::string GeometrySource(const std::vector<Varying>& varyings)
{
  return CornerOutputs(varyings, 1) + point_geometry_glsl;
}

std::string FragmentSource(const std::vector<Varying>& varyings, std::string& fragment)
{
  ReplaceAll(fragment, "gl_PointCoord", "wfvPointCoord");
  return point_fragment_glsl + CornerInputs(varyings, { "1.0" });
}
}
}
