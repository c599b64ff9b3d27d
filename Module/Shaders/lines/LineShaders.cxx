// SPDX-License-Identifier: BSD-3-Clause
#include "Shaders/lines/LineShaders.h"

#include "Compat/StockEdits.h"
#include "WideFoVGlsl.h"

#include <algorithm>

namespace wfv
{
namespace line
{
using namespace shader;

namespace
{
// Of one vertex, beside the varyings: position, primitive number, and what
// line_geometry.glsl writes (3 + 3 + 4 + 4 + 1).
constexpr int LineComponents = 4 + 1 + 15;

// And where the map does not show the whole of an arc, or no eye sees all of it.
constexpr int RangeComponents = 2;

// And of an eye whose rays begin in several places (line_noncentral.glsl).
constexpr int FootComponents = 4;

// Rectangles that the stage may emit: more than these it never needs; with fewer than
// these a window is too small a price.
constexpr int MostQuads = 12;
constexpr int FewestQuads = 3;

int LineVertices(const Request& r, const std::vector<Varying>& varyings)
{
  const bool rays = NonCentral(r);
  const bool cut = r.Projection->Axis == Family::Faces || r.Projection->FlatRim || rays;
  const int own = LineComponents + (cut ? RangeComponents : 0) + (rays ? FootComponents : 0);
  const int quads = MostComponents / (4 * (own + CornerComponents(varyings, 2)));
  return 4 * std::min(std::max(quads, FewestQuads), MostQuads);
}

// The stock normal lies across the line and towards the viewer, by derivatives, which a
// strip has none of along its width: from the ends of the line and the pixel's own
// direction instead.
void RewriteNormal(const Request& r, const std::vector<Varying>& varyings, std::string& fragment)
{
  const bool asked = r.Stock.Light != stock::Lit::No && !r.Stock.Normals && r.Stock.Wireframe;
  for (size_t i = 0; i < varyings.size(); i++)
  {
    if (varyings[i].Name == "vertexVCVSOutput")
    {
      const std::string direction = Corner(i, 1) + ".xyz - " + Corner(i, 0) + ".xyz";
      stock::Replace(fragment, stock::Edit::LineNormal,
        "wfvLineNormal(" + direction + ", vertexVC.xyz)", r.Stock.If(asked));
    }
  }
}
}

bool Draws(const Request& r)
{
  return r.Kind == Primitive::Lines && r.Stage == wfv::ShaderBuilder::Variant::Exact &&
    r.Projection->Axis != Family::Planar;
}

std::string GeometrySource(const Request& r, const std::vector<Varying>& varyings)
{
  const std::string head = Define("WFV_LINE_VERTICES", LineVertices(r, varyings)) + line_arc_glsl;
  const std::string corners = CornerOutputs(varyings, 2);
  if (NonCentral(r))
  {
    return head + line_noncentral_glsl + line_noncentral_frame_glsl + line_noncentral_tops_glsl +
      corners + line_emit_glsl + line_shapes_glsl + line_noncentral_geometry_glsl +
      line_geometry_glsl;
  }
  const Family family = r.Projection->Axis;
  return head + line_frame_glsl + corners + line_emit_glsl + line_shapes_glsl + line_central_glsl +
    (family == Family::Faces        ? line_on_faces_glsl
        : family == Family::Sampled ? std::string(places_glsl) + line_on_directions_glsl
                                    : line_arcs_glsl) +
    line_geometry_glsl;
}

std::string FragmentSource(
  const Request& r, const std::vector<Varying>& varyings, std::string& fragment)
{
  RewriteNormal(r, varyings, fragment);
  const bool localMap = r.Projection->Axis == Family::Sampled && !NonCentral(r);
  return std::string(line_arc_glsl) +
    (NonCentral(r) ? std::string(line_noncentral_glsl) + line_noncentral_fragment_glsl : "") +
    line_fragment_glsl +
    (localMap ? std::string(local_map_glsl) + line_local_map_glsl
              : std::string(line_newton_glsl) + line_starts_glsl + line_nearest_glsl) +
    CornerInputs(varyings, { "(1.0 - wfvAlong)", "wfvAlong" });
}
}
}
