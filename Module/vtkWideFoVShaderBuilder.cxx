// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWideFoVShaderBuilder.h"

#include "WideFoVGlsl.h"
#include "vtkWideFoVLineShaders.h"
#include "vtkWideFoVShaderArrays.h"

#include <regex>

namespace
{
using Request = vtkWideFoVShaderBuilder::Request;
using Primitive = vtkWideFoVShaderBuilder::Primitive;
using wfv::FindVaryings;
using wfv::ReplaceAll;
using wfv::Varying;

// Newton steps of the lens inverse in float32: from half the range, quadratic
// convergence reaches float32's end in fewer.
constexpr int NewtonSteps = 12;

std::string Define(const char* name, int value)
{
  return std::string("#define ") + name + " " + std::to_string(value) + "\n";
}

// The mathematics of the view, for any stage.
std::string ViewSource(const Request& r)
{
  const bool meridian = r.Projection->Axis == wfv::Family::Meridian;
  return "#define WFV_FN\n" + Define("WFV_NEWTON_STEPS", NewtonSteps) +
    Define("WFV_MERIDIAN", meridian) +
    Define("WFV_ROUND", r.Projection->Axis == wfv::Family::Azimuthal) +
    Define("WFV_STRAIGHT_SEAM", r.Projection->StraightSeam) +
    Define("WFV_EXACT", r.Stage == vtkWideFoVShaderBuilder::Variant::Exact) +
    Define("WFV_TESSELLATE", r.Stage == vtkWideFoVShaderBuilder::Variant::Tessellate) +
    Define("WFV_EDGES", r.Edges || r.DebugView) + Define("WFV_EDGE_FLAGS", r.EdgeFlags) +
    Define("WFV_DEBUG_VIEW", r.DebugView) + "#define WFV_ANGLES " +
    (meridian ? "wfvMeridianAngles" : "wfvAzimuthalAngles") + "\n" + wfv::MathGlsl() +
    wfv::CommonGlsl() + wfv::DepthGlsl() + r.Projection->Glsl + interface_glsl;
}

// How the picture of a triangle is covered, one file a family.
std::string CoverSource(const wfv::Projection& projection)
{
  return projection.Axis == wfv::Family::Meridian ? cover_meridian_glsl : cover_azimuthal_glsl;
}

// Copies of every vertex output at the three corners, which the fragment stage
// weighs: exact wherever the geometry stage cuts.
std::string TriangleFragment(const std::vector<Varying>& varyings)
{
  return std::string(ray_fragment_glsl) + cover_fragment_glsl + chord_fragment_glsl +
    wfv::CornerInputs(varyings, { "wfvB.x", "wfvB.y", "wfvB.z" });
}

// The geometry stage of lines or triangles.
std::string GeometrySource(const Request& r, const std::vector<Varying>& varyings)
{
  std::string source = "//VTK::System::Dec\n" + ViewSource(r) + preclip_glsl +
    (r.DebugView ? debug_kinds_glsl : "") +
    (r.Kind == Primitive::Lines ? wfv::LineGeometry(varyings)
                                : wfv::CornerOutputs(varyings, 3) + preclip_emit_glsl +
          preclip_cover_glsl + CoverSource(*r.Projection) +
          (r.DebugView ? preclip_kinds_glsl : "") + preclip_triangles_glsl);
  if (r.Stage == vtkWideFoVShaderBuilder::Variant::Tessellate)
  {
    ReplaceAll(source, "gl_PrimitiveIDIn", "wfvPrimitive[0]");
  }
  return source;
}

// The stock text takes normal.z for the cosine towards the eye and the view axis for
// the direction of a headlight; both hold in front of the eye only.
void RewriteLights(std::string& fragment)
{
  // the first statement of the stock main, whatever main is called by now
  const std::string position = "vec4 vertexVC = vertexVCVSOutput;";
  const size_t inside = fragment.find(position);
  if (inside == std::string::npos)
  {
    return;
  }
  std::string head = fragment.substr(0, inside);
  std::string body = fragment.substr(inside);
  vtkWideFoVShaderBuilder::Declare(head, light_fragment_glsl);
  ReplaceAll(body, position, position + "\n  wfvFromEye = normalize(vertexVC.xyz);");
  ReplaceAll(body, "max(0.0,normalVCVSOutput.z)", "max(0.0, dot(normalVCVSOutput, -wfvFromEye))");
  body = std::regex_replace(
    body, std::regex(R"(\blightDirectionVC(\d+))"), "wfvLightDirection($1, lightDirectionVC$1)");
  fragment = head + body;
}

// The wide camera's view and clip coordinates are the same; both stock statements are
// replaced, so that neighbours and attributes agree to the bit.
void TakeFromEye(std::string& vertex)
{
  static const std::regex product(R"(\bMC[DV]CMatrix\s*\*\s*vertexMC\b)");
  if (std::regex_search(vertex, product))
  {
    vertex = std::regex_replace(vertex, product, "wfvFromEyeOf(MCDCMatrix, vertexMC)");
    vtkWideFoVShaderBuilder::Declare(vertex, eye_vertex_glsl);
  }
}

bool CoversTriangles(const Request& r)
{
  return vtkWideFoVShaderBuilder::NeedsGeometryStage(r) && r.Kind == Primitive::Triangles;
}

// Depth by wfvDepth instead of the rasterizer's; returns what main begins with.
std::string RewriteDepth(std::string& fragment)
{
  ReplaceAll(fragment, "gl_FragCoord.z", "wfvDepth");
  // the stock template names gl_FragDepth in a comment; only a value given counts
  static const std::regex setsDepth(R"(gl_FragDepth\s*=)");
  return std::regex_search(fragment, setsDepth) ? "" : "  gl_FragDepth = wfvDepth;\n";
}

// What the debug view adds to the fragment stage.
std::string DebugSource(const Request& r)
{
  if (!r.DebugView)
  {
    return "";
  }
  const bool triangles = r.Kind == Primitive::Triangles;
  return Define("WFV_DEBUG_TRIANGLES", CoversTriangles(r)) + "#define WFV_DEBUG_KIND " +
    (triangles ? "WFV_KIND_VERTEX" : "WFV_KIND_OTHER") + "\n" + debug_kinds_glsl +
    debug_fragment_glsl;
}

void FinishFragment(const Request& r, const std::vector<Varying>& varyings, std::string& fragment)
{
  const bool covered = vtkWideFoVShaderBuilder::NeedsGeometryStage(r);
  std::string declarations, before, after;
  if (covered)
  {
    wfv::RemoveInputs(fragment, varyings);
    const bool exact = r.Stage == vtkWideFoVShaderBuilder::Variant::Exact;
    declarations = CoversTriangles(r) ? TriangleFragment(varyings)
                                      : wfv::LineFragment(varyings, exact, fragment);
    before = "  wfvPrepare();\n";
    after = "  if (wfvHide) { discard; }\n";
    ReplaceAll(fragment, "gl_FrontFacing", "wfvFront");
    before += RewriteDepth(fragment);
  }
  else if (r.FragmentDepth)
  {
    declarations = depth_fragment_glsl;
    before = "  wfvPrepareDepth();\n" + RewriteDepth(fragment);
  }
  if (r.Projection->Axis == wfv::Family::Azimuthal)
  {
    declarations += domain_fragment_glsl;
    after += "  if (wfvOutsideDomain()) { discard; }\n";
  }
  declarations += DebugSource(r);
  RewriteLights(fragment);
  if (!before.empty() || !after.empty())
  {
    vtkWideFoVShaderBuilder::WrapMain(fragment, before, after);
  }
  if (!declarations.empty())
  {
    // for gl_SampleMask; without it a covered pixel is covered whole
    const std::string extension = "#extension GL_ARB_sample_shading : enable\n";
    vtkWideFoVShaderBuilder::Declare(
      fragment, (covered ? extension : "") + ViewSource(r) + declarations);
  }
}
}

std::string vtkWideFoVShaderBuilder::MakeViewSource(const Request& r)
{
  return ViewSource(r);
}

bool vtkWideFoVShaderBuilder::NeedsGeometryStage(const Request& r)
{
  return r.Stage != Variant::Plain && r.Kind != Primitive::Points;
}

void vtkWideFoVShaderBuilder::WrapMain(
  std::string& source, const std::string& before, const std::string& after)
{
  static const std::regex main(R"(void\s+main\s*\(\s*(void)?\s*\))");
  int depth = 0;
  while (source.find("void wfvStockMain" + std::to_string(depth) + "()") != std::string::npos)
  {
    depth++;
  }
  const std::string name = "wfvStockMain" + std::to_string(depth) + "()";
  source =
    std::regex_replace(source, main, "void " + name, std::regex_constants::format_first_only);
  source += "\nvoid main()\n{\n" + before + "  " + name + ";\n" + after + "}\n";
}

void vtkWideFoVShaderBuilder::Declare(std::string& source, const std::string& text)
{
  const std::string tag = "//VTK::System::Dec";
  const size_t at = source.find(tag);
  const size_t line = at == std::string::npos ? 0 : source.find('\n', at) + 1;
  source.insert(line, text);
}

void vtkWideFoVShaderBuilder::Prepare(
  const Request& r, std::string& geometry, std::string& fragment)
{
  if (r.DebugView)
  {
    // in place of the surface's own colour, before light falls on it; textures stay out
    ReplaceAll(fragment, "//VTK::Light::Impl",
      "  diffuseColor = wfvDebugColor();\n"
      "  ambientColor = WFV_DEBUG_AMBIENT * diffuseColor;\n"
      "  diffuseColor -= ambientColor;\n"
      "  //VTK::Light::Impl");
    ReplaceAll(fragment, "//VTK::TCoord::Impl", "");
  }
  if (!NeedsGeometryStage(r))
  {
    return;
  }
  geometry.clear();
  if (r.Edges)
  {
    ReplaceAll(fragment, "//VTK::Edges::Dec", edges_fragment_glsl);
    ReplaceAll(fragment, "//VTK::Edges::Impl",
      "  float wfvEdge = wfvEdgeMix();\n"
      "  diffuseColor = mix(diffuseColor, vec3(0.0), wfvEdge);\n"
      "  ambientColor = mix(ambientColor, edgeColor, wfvEdge);\n");
  }
}

void vtkWideFoVShaderBuilder::Finish(
  const Request& r, std::string& vertex, std::string& geometry, std::string& fragment)
{
  if (NeedsGeometryStage(r))
  {
    wfv::FlattenArrays(vertex, fragment);
  }
  TakeFromEye(vertex);
  if (r.FragmentDepth && !CoversTriangles(r))
  {
    WrapMain(vertex, "", "  wfvPlaceVSOutput = gl_Position.xyz;\n");
    Declare(vertex, depth_vertex_glsl);
  }
  if (r.Stage == Variant::Tessellate)
  {
    // drivers disagree on gl_PrimitiveIDIn behind a tessellation: a number of our own,
    // which the evaluation stage sets
    Declare(vertex, "flat out int wfvPrimitive;\n");
    WrapMain(vertex, "", "  wfvPrimitive = 0;\n");
  }
  const std::vector<Varying> varyings = FindVaryings(vertex);
  if (NeedsGeometryStage(r))
  {
    geometry = GeometrySource(r, varyings);
  }
  else
  {
    WrapMain(vertex, "", "  gl_Position = wfvProjectVertex(gl_Position.xyz);\n");
    Declare(vertex, ViewSource(r));
  }
  FinishFragment(r, varyings, fragment);
}
