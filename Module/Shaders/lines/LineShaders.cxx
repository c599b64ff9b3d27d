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
  const bool cut = r.View.Projection->Axis == Family::Faces || r.View.Projection->FlatRim || rays;
  const int own = LineComponents + (cut ? RangeComponents : 0) + (rays ? FootComponents : 0);
  const int quads = MostComponents / (4 * (own + CornerComponents(varyings, 2)));
  return 4 * std::min(std::max(quads, FewestQuads), MostQuads);
}

// What tells the direction of a line, where light is to fall on it: the stock normal lies across it
// and towards the viewer, by derivatives, which a line has none of along its width.
const char* const Place = "vertexVCVSOutput";

bool KnowsPlace(const std::vector<Varying>& varyings)
{
  return std::any_of(
    varyings.begin(), varyings.end(), [](const Varying& v) { return v.Name == Place; });
}

// Of one vertex of a chord, beside the varyings: position, primitive number, place,
// and perhaps the direction.
constexpr int ChordComponents = 4 + 1 + 3 + 3;

// Vertices that the stage may emit for the chords of a line: more than these it hardly needs, and
// a stage that may emit more takes longer on some drivers.
constexpr int MostChordVertices = 96;

int ChordVertices(const std::vector<Varying>& varyings)
{
  const int own = ChordComponents + CornerComponents(varyings, 1);
  return std::min(MostComponents / own, MostChordVertices);
}

// What light asks of a chord.
const char* const DirectionSource =
  "flat out vec3 wfvDirectionGSOutput;\n"
  "void wfvWriteDirection()\n{\n"
  "  wfvDirectionGSOutput = vertexVCVSOutput[1].xyz - vertexVCVSOutput[0].xyz;\n}\n";

void RewriteNormal(const Request& r, const std::string& direction, std::string& fragment)
{
  const bool asked = r.Stock.Light != stock::Lit::No && !r.Stock.Normals && r.Stock.Wireframe;
  stock::Replace(fragment, stock::Edit::LineNormal,
    "wfvLineNormal(" + direction + ", vertexVC.xyz)", r.Stock.If(asked));
}

// The direction between the copies of both ends.
std::string DirectionOfCorners(const std::vector<Varying>& varyings)
{
  const auto place = std::find_if(
    varyings.begin(), varyings.end(), [](const Varying& v) { return v.Name == Place; });
  const auto i = static_cast<size_t>(place - varyings.begin());
  return Corner(i, 1) + ".xyz - " + Corner(i, 0) + ".xyz";
}
}

bool DrawsChords(const Request& r)
{
  return r.Kind == Primitive::Lines && r.Stage != wfv::ShaderBuilder::Variant::Projected &&
    !Draws(r);
}

std::string ChordSource(const std::vector<Varying>& varyings)
{
  const bool known = KnowsPlace(varyings);
  return Define("WFV_CHORD_VERTICES", ChordVertices(varyings)) +
    MixedOutputs(varyings, "float t", { "(1.0 - t)", "t" }) +
    (known ? DirectionSource : "void wfvWriteDirection() {}\n") + line_places_glsl +
    line_pieces_glsl + line_chords_glsl;
}

std::string ChordFragment(
  const Request& r, const std::vector<Varying>& varyings, std::string& fragment)
{
  if (!KnowsPlace(varyings))
  {
    return "";
  }
  RewriteNormal(r, "wfvDirectionVSOutput", fragment);
  return std::string("flat in vec3 wfvDirectionVSOutput;\n") + line_normal_glsl;
}

std::string StockFragment(const Request& r, std::string& fragment)
{
  if (fragment.find(Place) == std::string::npos)
  {
    return "";
  }
  RewriteNormal(r, "wfvLineWay(vertexVC.xyz)", fragment);
  return std::string(line_normal_glsl) + line_way_glsl;
}

bool Draws(const Request& r)
{
  return r.Kind == Primitive::Lines && r.Stage == wfv::ShaderBuilder::Variant::Exact &&
    r.View.Projection->Axis != Family::Planar;
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
  const Family family = r.View.Projection->Axis;
  return head + line_frame_glsl + corners + line_emit_glsl + line_shapes_glsl + line_central_glsl +
    (family == Family::Faces        ? line_on_faces_glsl
        : family == Family::Sampled ? std::string(places_glsl) + line_on_directions_glsl
                                    : line_arcs_glsl) +
    line_geometry_glsl;
}

std::string FragmentSource(
  const Request& r, const std::vector<Varying>& varyings, std::string& fragment)
{
  const bool normal = KnowsPlace(varyings);
  if (normal)
  {
    RewriteNormal(r, DirectionOfCorners(varyings), fragment);
  }
  const bool localMap = r.View.Projection->Axis == Family::Sampled && !NonCentral(r);
  return std::string(line_arc_glsl) +
    (NonCentral(r) ? std::string(line_noncentral_glsl) + line_noncentral_fragment_glsl : "") +
    line_fragment_glsl +
    (localMap ? std::string(local_map_glsl) + line_local_map_glsl
              : std::string(line_newton_glsl) + line_starts_glsl + line_nearest_glsl) +
    (normal ? line_normal_glsl : "") + CornerInputs(varyings, { "(1.0 - wfvAlong)", "wfvAlong" });
}
}
}
