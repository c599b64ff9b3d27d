// SPDX-License-Identifier: BSD-3-Clause
#include "Shaders/points/PointShaders.h"

#include "Compat/StockEdits.h"
#include "WideFoVGlsl.h"

namespace wfv
{
namespace point
{
using namespace shader;

namespace
{
bool OnDirections(const Request& r)
{
  return r.View.Projection->Axis == Family::Sampled;
}
}

bool Draws(const Request& r)
{
  // behind a flat rim even a small one would show, as if it were on it; and what a direction map
  // shows where is not found for sure
  const bool always = r.View.Projection->FlatRim || OnDirections(r);
  return r.Kind == Primitive::Points && (r.Points.Wide || always) &&
    r.Stage != wfv::ShaderBuilder::Variant::Projected;
}

std::string GeometrySource(const Request& r, const std::vector<Varying>& varyings)
{
  const std::string corners = CornerOutputs(varyings, 1);
  return OnDirections(r) ? corners + places_glsl + point_on_directions_glsl
                         : corners + point_geometry_glsl;
}

std::string FragmentSource(
  const Request& r, const std::vector<Varying>& varyings, std::string& fragment)
{
  stock::Replace(fragment, stock::Edit::PointCoordinate, "wfvPointCoord", stock::Found::May);
  const std::string inputs = CornerInputs(varyings, { "1.0" });
  return OnDirections(r) ? std::string(local_map_glsl) + point_local_map_glsl + inputs
                         : point_fragment_glsl + inputs;
}
}
}
