// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWideFoVShaderBuilder.h"

#include "WideFoVGlsl.h"
#include "vtkWideFoVQuadricShaders.h"
#include "vtkWideFoVShaderText.h"

#include <regex>
#include <vector>

namespace wfv
{
namespace shader
{
namespace
{
// Newton steps of the lens inverse in float32: from half the range, quadratic
// convergence reaches float32's end in fewer.
constexpr int NewtonSteps = 12;

}

std::vector<Varying> FindVaryings(const std::string& vertex)
{
  static const std::regex output(
    R"((flat\s+|smooth\s+|noperspective\s+)?\bout\s+(\w+)\s+(\w+)\s*;)");
  std::vector<Varying> result;
  for (std::sregex_iterator i(vertex.begin(), vertex.end(), output), end; i != end; ++i)
  {
    result.push_back({ (*i)[1].str().compare(0, 4, "flat") == 0, (*i)[2], (*i)[3] });
  }
  return result;
}

namespace
{
// One array of floats between the stages as vectors of four.
struct PackedArray
{
  std::string Outputs;
  std::string Inputs;
  std::string Pack;
  std::string Unpack;
};

PackedArray PackArray(const std::string& name, int count, int number)
{
  PackedArray p;
  for (int first = 0; first < count; first += 4)
  {
    const std::string vector =
      "wfvArray" + std::to_string(number) + "_" + std::to_string(first / 4) + "VSOutput";
    p.Outputs += "out vec4 " + vector + ";\n";
    p.Inputs += "in vec4 " + vector + ";\n";
    p.Pack += "  " + vector + " = vec4(";
    for (int k = 0; k < 4; k++)
    {
      const std::string at = name + "[" + std::to_string(first + k) + "]";
      p.Pack += (k ? ", " : "") + (first + k < count ? at : std::string("0.0"));
      p.Unpack +=
        first + k < count ? "  " + at + " = " + vector + "[" + std::to_string(k) + "];\n" : "";
    }
    p.Pack += ");\n";
  }
  return p;
}

}

void FlattenArrays(std::string& vertex, std::string& fragment)
{
  static const std::regex array(R"(\bout\s+float\s+(\w+)\s*\[\s*(\d+)\s*\]\s*;)");
  std::smatch m;
  for (int i = 0; std::regex_search(vertex, m, array); i++)
  {
    const std::string name = m[1];
    const std::string declaration = "float " + name + "[" + m[2].str() + "];\n";
    const PackedArray p = PackArray(name, std::stoi(m[2]), i);
    const std::regex input(R"(\bin\s+float\s+)" + name + R"(\s*\[\s*\d+\s*\]\s*;)");
    fragment = std::regex_replace(fragment, input, p.Inputs + declaration);
    vertex.replace(m.position(0), m.length(0), p.Outputs + declaration);
    vtkWideFoVShaderBuilder::WrapMain(vertex, "", p.Pack);
    vtkWideFoVShaderBuilder::WrapMain(fragment, p.Unpack, "");
  }
}

void RemoveInputs(std::string& fragment, const std::vector<Varying>& varyings)
{
  for (const Varying& v : varyings)
  {
    const std::regex input(
      R"((flat\s+|smooth\s+|noperspective\s+)?\bin\s+)" + v.Type + R"(\s+)" + v.Name + R"(\s*;)");
    fragment = std::regex_replace(fragment, input, "");
  }
}

void ReplaceAll(std::string& text, const std::string& from, const std::string& to)
{
  for (size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
  {
    text.replace(at, from.size(), to);
  }
}

std::string Define(const char* name, int value)
{
  return std::string("#define ") + name + " " + std::to_string(value) + "\n";
}

std::string ViewSource(const Request& r)
{
  const bool meridian = r.Projection->Axis == wfv::Family::Meridian;
  return "#define WFV_FN\n" + Define("WFV_NEWTON_STEPS", NewtonSteps) +
    Define("WFV_MERIDIAN", meridian) + Define("WFV_STRAIGHT_SEAM", r.Projection->StraightSeam) +
    Define("WFV_EXACT", r.Stage == vtkWideFoVShaderBuilder::Variant::Exact) +
    Define("WFV_TESSELLATE", r.Stage == vtkWideFoVShaderBuilder::Variant::Tessellate) +
    Define("WFV_WIDE_LINES", r.WideLines) + Define("WFV_EDGES", r.Edges) +
    Define("WFV_EDGE_FLAGS", r.EdgeFlags) + "#define WFV_ANGLES " +
    (meridian ? "wfvMeridianAngles" : "wfvAzimuthalAngles") + "\n" + wfv::MathGlsl() +
    wfv::CommonGlsl() + r.Projection->Glsl + interface_glsl;
}

std::string Corner(size_t varying, int corner)
{
  return "wfvCorner" + std::to_string(varying) + "_" + std::to_string(corner);
}

namespace
{
// How the picture of a triangle is covered, one file a family.
std::string CoverSource(const wfv::Projection& projection)
{
  return projection.Axis == wfv::Family::Meridian ? cover_meridian_glsl : cover_azimuthal_glsl;
}

// Copies of every vertex output at the three corners, which the fragment stage
// weighs: exact wherever the geometry stage cuts.
std::string TriangleOutputs(const std::vector<Varying>& varyings)
{
  std::string declarations;
  std::string body;
  for (size_t i = 0; i < varyings.size(); i++)
  {
    const Varying& v = varyings[i];
    declarations += v.Input();
    for (int c = v.Flat ? 2 : 0; c < 3; c++)
    {
      declarations += "flat out " + v.Declaration(Corner(i, c));
      body += "  " + Corner(i, c) + " = " + v.Name + "[" + std::to_string(c) + "];\n";
    }
  }
  return declarations + "void wfvWriteCorners()\n{\n" + body + "}\n";
}

std::string TriangleInputs(const std::vector<Varying>& varyings)
{
  std::string declarations;
  std::string body;
  for (size_t i = 0; i < varyings.size(); i++)
  {
    const Varying& v = varyings[i];
    declarations += v.Declaration(v.Name);
    for (int c = v.Flat ? 2 : 0; c < 3; c++)
    {
      declarations += "flat in " + v.Declaration(Corner(i, c));
    }
    body += "  " + v.Name + " = ";
    body += v.Flat ? Corner(i, 2) + ";\n"
                   : "wfvB.x * " + Corner(i, 0) + " + wfvB.y * " + Corner(i, 1) + " + wfvB.z * " +
        Corner(i, 2) + ";\n";
  }
  return declarations + "void wfvInterpolate()\n{\n" + body + "}\n";
}

// Lines carry every output on, mixed between the two ends. VTK itself renames the
// fragment stage's VSOut to GSOut.
std::string LineOutputs(const std::vector<Varying>& varyings)
{
  std::string declarations;
  std::string body;
  for (const Varying& v : varyings)
  {
    std::string out = v.Name;
    ReplaceAll(out, "VSOut", "GSOut");
    if (out == v.Name)
    {
      continue;
    }
    declarations += v.Input();
    declarations += (v.Flat ? "flat out " : "out ") + v.Declaration(out);
    body += "  " + out + " = ";
    body += v.Flat ? v.Name + "[1];\n" : "mix(" + v.Name + "[0], " + v.Name + "[1], t);\n";
  }
  return declarations + "void wfvWriteMix(float t)\n{\n" + body + "}\n";
}

}

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

void TakeFromEye(std::string& vertex)
{
  static const std::regex product(R"(\bMC[DV]CMatrix\s*\*\s*vertexMC\b)");
  if (std::regex_search(vertex, product))
  {
    const bool both = vertex.find("MCDCMatrix") != std::string::npos;
    const std::string matrix = both ? "MCDCMatrix" : "MCVCMatrix";
    vertex = std::regex_replace(vertex, product, "wfvFromEyeOf(" + matrix + ", vertexMC)");
    vtkWideFoVShaderBuilder::Declare(vertex, eye_vertex_glsl);
  }
}

namespace
{
void FinishFragment(const Request& r, const std::vector<Varying>& varyings, std::string& fragment)
{
  const bool triangles =
    vtkWideFoVShaderBuilder::NeedsGeometryStage(r) && r.Kind == Primitive::Triangles;
  const bool round = r.Projection->Axis == wfv::Family::Azimuthal;
  std::string declarations;
  std::string before;
  std::string after;
  if (triangles)
  {
    RemoveInputs(fragment, varyings);
    declarations = std::string(ray_fragment_glsl) + cover_fragment_glsl + chord_fragment_glsl +
      TriangleInputs(varyings);
    before = "  wfvPrepare();\n";
    after = "  if (wfvHide) { discard; }\n";
    ReplaceAll(fragment, "gl_FragCoord.z", "wfvDepth");
    ReplaceAll(fragment, "gl_FrontFacing", "wfvFront");
    // the stock template names gl_FragDepth in a comment; only a value given counts
    static const std::regex setsDepth(R"(gl_FragDepth\s*=)");
    before += std::regex_search(fragment, setsDepth) ? "" : "  gl_FragDepth = wfvDepth;\n";
  }
  if (round)
  {
    declarations += domain_fragment_glsl;
    after += "  if (wfvOutsideDomain()) { discard; }\n";
  }
  RewriteLights(fragment);
  if (!after.empty())
  {
    vtkWideFoVShaderBuilder::WrapMain(fragment, before, after);
    // for gl_SampleMask; without it a covered pixel is covered whole
    const std::string extension = "#extension GL_ARB_sample_shading : enable\n";
    vtkWideFoVShaderBuilder::Declare(
      fragment, (triangles ? extension : "") + ViewSource(r) + declarations);
  }
}
}
}
}

using namespace wfv::shader;

std::string vtkWideFoVShaderBuilder::MakeViewSource(const Request& r)
{
  return ViewSource(r);
}

bool vtkWideFoVShaderBuilder::NeedsGeometryStage(const Request& r)
{
  return wfv::quadric::Draws(r.Kind) || (r.Stage != Variant::Plain && r.Kind != Primitive::Points);
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
  if (wfv::quadric::Draws(r.Kind))
  {
    return wfv::quadric::Finish(r, vertex, geometry, fragment);
  }
  if (NeedsGeometryStage(r))
  {
    FlattenArrays(vertex, fragment);
  }
  TakeFromEye(vertex);
  const bool tessellate = r.Stage == Variant::Tessellate;
  if (tessellate)
  {
    // drivers disagree on gl_PrimitiveIDIn behind a tessellation: a number of our own,
    // which the evaluation stage sets
    Declare(vertex, "flat out int wfvPrimitive;\n");
    WrapMain(vertex, "", "  wfvPrimitive = 0;\n");
  }
  const std::vector<Varying> varyings = FindVaryings(vertex);
  if (NeedsGeometryStage(r))
  {
    geometry = "//VTK::System::Dec\n" + ViewSource(r) + preclip_glsl +
      (r.Kind == Primitive::Lines ? LineOutputs(varyings) + preclip_lines_glsl
                                  : TriangleOutputs(varyings) + preclip_emit_glsl +
            preclip_cover_glsl + CoverSource(*r.Projection) + preclip_triangles_glsl);
    if (tessellate)
    {
      ReplaceAll(geometry, "gl_PrimitiveIDIn", "wfvPrimitive[0]");
    }
  }
  else
  {
    WrapMain(vertex, "", "  gl_Position = wfvProjectVertex(gl_Position.xyz);\n");
    Declare(vertex, ViewSource(r));
  }
  FinishFragment(r, varyings, fragment);
}
