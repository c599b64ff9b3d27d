// SPDX-License-Identifier: BSD-3-Clause
#include "Shaders/ShaderBuilder.h"

#include "Compat/StockEdits.h"
#include "Shaders/ShaderArrays.h"
#include "Shaders/ShaderText.h"
#include "Shaders/lines/LineShaders.h"
#include "Shaders/points/PointShaders.h"
#include "Shaders/quadrics/QuadricShaders.h"
#include "Shaders/triangles/TriangleShaders.h"
#include "WideFoVGlsl.h"

#include <vector>

using namespace wfv::shader;
namespace stock = wfv::stock;
using stock::Edit;
using stock::Found;

namespace
{
// True if an eye whose rays begin in several places is served by moving the vertices.
bool MovesVertices(const Request& r)
{
  return r.View.Stereo && !r.View.Stereo->Traits.OneCenter && !wfv::triangle::Covers(r) &&
    !wfv::quadric::Draws(r.Kind) && !wfv::line::Draws(r) && !wfv::line::DrawsChords(r);
}

// For the few planes that float32 is too coarse for; without it they are as good as it is.
// (Images: for an order as fine, fine_depth.glsl.)
const char* const Doubles = "#extension GL_ARB_gpu_shader_fp64 : enable\n"
                            "#extension GL_ARB_shader_image_load_store : enable\n";

// For gl_SampleMask; without it a covered pixel is covered whole.
const char* const SampleMasks = "#extension GL_ARB_sample_shading : enable\n";

// For a stage that is invoked several times for a triangle; without it there is one run alone.
const char* const Invocations = "#extension GL_ARB_gpu_shader5 : enable\n";

// The geometry stage of points, lines or triangles, behind what all have.
std::string PrimitiveSource(const Request& r, const std::vector<Varying>& varyings)
{
  if (wfv::point::Draws(r))
  {
    return wfv::point::GeometrySource(r, varyings);
  }
  if (wfv::line::Draws(r))
  {
    return wfv::line::GeometrySource(r, varyings);
  }
  if (r.Kind == Primitive::Lines)
  {
    return wfv::line::ChordSource(varyings);
  }
  return wfv::triangle::GeometrySource(r, varyings);
}

// The two draws of a refined mesh give a vertex the same place, or pixels between them were left
// out.
const char* const SamePlaces = "invariant gl_Position;\n";

// toView: the name of the matrix from the vertex buffer to view coordinates; empty where the
// coordinates of the buffer do not come along.
std::string GeometrySource(
  const Request& r, const std::vector<Varying>& varyings, const std::string& toView)
{
  const bool runs = wfv::triangle::Covers(r) || wfv::line::DrawsChords(r);
  std::string source = std::string("//VTK::System::Dec\n") +
    (wfv::triangle::Covers(r) ? Doubles : "") + (runs ? Invocations : "") +
    Define("WFV_MODEL", !toView.empty()) + "#define WFV_TO_VIEW " + toView + "\n" + ViewSource(r) +
    (r.Kind == Primitive::Points ? "" : EdgeSource()) + (r.DebugView ? debug_kinds_glsl : "") +
    PrimitiveSource(r, varyings);
  return source;
}

// True where depth is not what the rasterizer interpolates: places are, on the surface.
bool WritesDepth(const Request& r)
{
  return r.View.DepthMapping != wfv::WFV_DEPTH_LINEAR || wfv::line::DrawsChords(r) ||
    (r.Stage == wfv::ShaderBuilder::Variant::Projected &&
      (r.Kind == Primitive::Triangles || r.Kind == Primitive::Lines));
}

// Where the vertices go: to a geometry stage, or into the map at once.
void FinishVertices(const Request& r, const std::vector<Varying>& varyings, std::string& vertex,
  std::string& geometry)
{
  const bool keepModel = wfv::triangle::Covers(r);
  const std::string toView = TakeFromEye(r, vertex, keepModel);
  if (wfv::ShaderBuilder::NeedsGeometryStage(r))
  {
    geometry = GeometrySource(r, varyings, keepModel ? toView : "");
  }
  else
  {
    const bool beside = r.Kind == Primitive::Triangles || r.Kind == Primitive::Lines;
    const std::string project = beside ? "wfvProjectBeside" : "wfvProjectVertex";
    wfv::ShaderBuilder::WrapMain(vertex, "", "  gl_Position = " + project + "(gl_Position.xyz);\n");
    wfv::ShaderBuilder::Declare(vertex,
      ViewSource(r) +
        (beside ? Define("WFV_WRITES_DEPTH", WritesDepth(r)) + beside_glsl : std::string()));
  }
  // not of what asks for extensions itself, as volumes do: nothing may be declared before those
  if (r.Kind == Primitive::Triangles && vertex.find("#extension") == std::string::npos)
  {
    wfv::ShaderBuilder::Declare(vertex, SamePlaces);
  }
}

// True where the fragment stage finds what of the primitive a pixel sees.
bool Covers(const Request& r)
{
  return wfv::triangle::Covers(r) || wfv::line::Draws(r) || wfv::point::Draws(r);
}

// What the fragment stage needs for that.
std::string CoverFragment(
  const Request& r, const std::vector<Varying>& varyings, std::string& fragment)
{
  if (wfv::line::Draws(r))
  {
    return wfv::line::FragmentSource(r, varyings, fragment);
  }
  if (wfv::point::Draws(r))
  {
    return wfv::point::FragmentSource(r, varyings, fragment);
  }
  return wfv::triangle::FragmentSource(r, varyings, fragment);
}

// What the debug view adds to the fragment stage.
std::string DebugSource(const Request& r)
{
  if (!r.DebugView)
  {
    return "";
  }
  const bool triangles = r.Kind == Primitive::Triangles;
  return Define("WFV_DEBUG_TRIANGLES", wfv::triangle::Covers(r)) + "#define WFV_DEBUG_KIND " +
    (triangles ? "WFV_KIND_VERTEX" : "WFV_KIND_OTHER") + "\n" + debug_kinds_glsl +
    debug_fragment_glsl;
}

// True where what is drawn reaches across the curved seam of a map.
bool EndsAtSeam(const Request& r)
{
  return r.View.Seam && (r.Kind == Primitive::Points || r.Kind == Primitive::Triangles);
}

// Where the map ends; empty where nothing reaches across. Of curved rays the border is
// elsewhere at every depth.
std::string BorderSource(const Request& r)
{
  const bool straight = !r.View.Stereo || r.View.Stereo->Traits.StraightRays;
  if (straight && r.View.Projection->Axis == wfv::Family::Azimuthal)
  {
    return domain_fragment_glsl;
  }
  return straight && EndsAtSeam(r) ? seam_fragment_glsl : "";
}

// What the fragment stage has as its place in view coordinates: the stock position, which light
// needs, or, where there is none or the vertices are moved, an output of our own.
const std::string StockPlace = "vertexVCVSOutput";
const std::string OwnPlace = "wfvPlaceVSOutput";

const std::string& PlaceOf(const Request& r, const std::string& fragment)
{
  const bool known = fragment.find(StockPlace) != std::string::npos && !MovesVertices(r) &&
    !wfv::line::DrawsChords(r);
  return known ? StockPlace : OwnPlace;
}

// True where the fragment stage is to know its place by an output of our own: for its depth, or for
// the distance that vtkWideFoVDataPass writes, which is along the ray of the eye.
bool KeepsPlace(const Request& r, const std::string& fragment)
{
  const bool writesData = MovesVertices(r) && fragment.find("wfvData(") != std::string::npos;
  return !Covers(r) && (WritesDepth(r) || writesData) && PlaceOf(r, fragment) == OwnPlace;
}

// VTK's own geometry stage takes the output along.
void TakePlaceAlong(const Request& r, std::string& geometry)
{
  const std::string behind = "wfvPlaceGSOutput"; // VTK renames the input of the fragment stage so
  stock::Replace(geometry, Edit::StripVertex, behind + " = " + OwnPlace + "[i];\n      $&",
    r.Stock.If(r.Kind == Primitive::Lines));
  wfv::ShaderBuilder::Declare(geometry, "in vec3 " + OwnPlace + "[];\nout vec3 " + behind + ";\n");
}

// What is needed for that.
std::string PlaceSource(const Request& r, const std::string& fragment)
{
  const bool moves = MovesVertices(r) || wfv::line::DrawsChords(r);
  const std::string distance = moves ? "#define WFV_DISTANCE length(" + OwnPlace + ")\n" : "";
  return KeepsPlace(r, fragment) ? "in vec3 " + OwnPlace + ";\n" + distance : "";
}

// What a fragment stage that covers asks OpenGL for.
std::string Extensions(const Request& r)
{
  return Covers(r) ? std::string(SampleMasks) + (r.Triangles.Fp64 ? Doubles : "") : "";
}

// Text that the fragment stage gets: before and after its stock main function, and declarations.
struct FragmentParts
{
  std::string Declarations;
  std::string Before;
  std::string After;
};

// Finds the primitive that the pixel sees, or writes the depth of the one that the rasterizer
// found.
void AddSurface(const Request& r, const std::vector<Varying>& varyings, std::string& fragment,
  FragmentParts& parts)
{
  if (Covers(r))
  {
    RemoveInputs(r, fragment, varyings);
    parts.Declarations = CoverFragment(r, varyings, fragment);
    parts.Before = "  wfvPrepare();\n";
    parts.After = "  if (wfvHide) { discard; }\n";
    stock::Replace(fragment, Edit::FrontFacing, "wfvFront", stock::Found::May);
    parts.Before += RewriteDepth(r, fragment);
  }
  else if (WritesDepth(r))
  {
    parts.Declarations += depth_fragment_glsl;
    parts.Before =
      "  wfvPrepareDepth(" + PlaceOf(r, fragment) + ".xyz);\n" + RewriteDepth(r, fragment);
  }
  else
  {
    RewriteOffset(fragment);
  }
  if (wfv::line::DrawsChords(r))
  {
    parts.Declarations += wfv::line::ChordFragment(r, varyings, fragment);
  }
  else if (r.Kind == Primitive::Lines && !Covers(r))
  {
    parts.Declarations += wfv::line::StockFragment(r, fragment);
  }
}

void FinishFragment(const Request& r, const std::vector<Varying>& varyings, std::string& fragment)
{
  FragmentParts parts;
  parts.Declarations = PlaceSource(r, fragment);
  AddSurface(r, varyings, fragment, parts);
  const std::string border = BorderSource(r);
  parts.Declarations += depth_offset_glsl + border + DebugSource(r);
  parts.After += border.empty() ? "" : "  if (wfvOutsideDomain()) { discard; }\n";
  parts.After +=
    Covers(r) && r.Triangles.Fp64 ? "  if (wfvIsBehind(gl_FragDepth)) { discard; }\n" : "";
  FoldMaterial(r.Surface, fragment);
  RewriteLights(r, fragment);
  if (!parts.Before.empty() || !parts.After.empty())
  {
    wfv::ShaderBuilder::WrapMain(fragment, parts.Before, parts.After);
  }
  wfv::ShaderBuilder::Declare(fragment, Extensions(r) + ViewSource(r) + parts.Declarations);
}
}

bool wfv::ShaderBuilder::NeedsGeometryStage(const Request& r)
{
  return wfv::quadric::Draws(r.Kind) || wfv::point::Draws(r) ||
    (r.Stage != Variant::Projected && r.Kind != Primitive::Points);
}

void wfv::ShaderBuilder::WrapMain(
  std::string& source, const std::string& before, const std::string& after)
{
  int depth = 0;
  while (source.find("void wfvStockMain" + std::to_string(depth) + "()") != std::string::npos)
  {
    depth++;
  }
  const std::string name = "wfvStockMain" + std::to_string(depth) + "()";
  const stock::Span main = stock::Look(source, Edit::MainFunction);
  if (main.Number >= 0)
  {
    source.replace(main.At, main.Length, "/* WideFoV: main function */ void " + name);
  }
  source += "\n// WideFoV: round the main function above\nvoid main()\n{\n" + before + "  " + name +
    ";\n" + after + "}\n";
}

void wfv::ShaderBuilder::Prepare(const Request& r, std::string& geometry, std::string& fragment)
{
  if (r.DebugView)
  {
    // in place of the surface's own colour, before light falls on it; textures stay out
    stock::Replace(fragment, Edit::ColorsLightPlace,
      "  diffuseColor = wfvDebugColor();\n"
      "  ambientColor = WFV_DEBUG_AMBIENT * diffuseColor;\n"
      "  diffuseColor -= ambientColor;\n"
      "  $&",
      r.Stock.If(true));
    stock::Replace(fragment, Edit::TextureColorPlace, "", r.Stock.If(true));
  }
  if (!NeedsGeometryStage(r))
  {
    return;
  }
  if (wfv::quadric::Draws(r.Kind))
  {
    wfv::quadric::Prepare(r, geometry, fragment);
    return;
  }
  geometry.clear();
  if (r.Triangles.Edges)
  {
    stock::Replace(fragment, Edit::EdgesDeclaration,
      Define("WFV_EDGE_OPACITY", stock::HasEdgeOpacity()) + edges_fragment_glsl, r.Stock.If(true));
    stock::Replace(fragment, Edit::EdgesPlace,
      "  float wfvEdge = wfvEdgeMix();\n"
      "  diffuseColor = mix(diffuseColor, vec3(0.0), wfvEdge);\n"
      "  ambientColor = mix(ambientColor, edgeColor, wfvEdge);\n",
      r.Stock.If(true));
  }
}

void wfv::ShaderBuilder::Finish(
  const Request& r, std::string& vertex, std::string& geometry, std::string& fragment)
{
  if (MovesVertices(r))
  {
    WrapMain(vertex, "", "  gl_Position = wfvSeenVertex(gl_Position);\n");
    // without a geometry stage the view's own text follows
    const bool pieces = r.Kind == Primitive::Triangles || r.Kind == Primitive::Lines;
    Declare(vertex,
      (NeedsGeometryStage(r) ? ViewSource(r) : "") + Define("WFV_PIECES", pieces) +
        stereo_vertex_glsl);
  }
  if (wfv::quadric::Draws(r.Kind))
  {
    return wfv::quadric::Finish(r, vertex, geometry, fragment);
  }
  if (NeedsGeometryStage(r))
  {
    wfv::FlattenArrays(r.Stock, vertex, fragment);
  }
  if (KeepsPlace(r, fragment) && !wfv::line::DrawsChords(r)) // whose geometry stage says it
  {
    WrapMain(vertex, "", "  " + OwnPlace + " = gl_Position.xyz;\n");
    Declare(vertex, "out vec3 " + OwnPlace + ";\n");
    if (!geometry.empty() && !NeedsGeometryStage(r))
    {
      TakePlaceAlong(r, geometry);
    }
  }
  const std::vector<Varying> varyings = FindVaryings(vertex);
  FinishVertices(r, varyings, vertex, geometry);
  FinishFragment(r, varyings, fragment);
}
