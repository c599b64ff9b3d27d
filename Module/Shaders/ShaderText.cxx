// SPDX-License-Identifier: BSD-3-Clause
#include "Shaders/ShaderText.h"

#include "Compat/StockEdits.h"
#include "Shaders/lines/LineShaders.h"
#include "Shaders/quadrics/QuadricShaders.h"
#include "WideFoVGlsl.h"

#include <regex>
#include <sstream>

namespace wfv
{
namespace shader
{
int Varying::Components() const
{
  const char last = this->Type.back();
  const int size = last >= '2' && last <= '4' ? last - '0' : 1;
  return this->Type.compare(0, 3, "mat") == 0 ? size * size : size;
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

void RemoveInputs(const Request& r, std::string& fragment, const std::vector<Varying>& varyings)
{
  for (const Varying& v : varyings)
  {
    const bool used = fragment.find(v.Name) != std::string::npos;
    stock::Replace(fragment, stock::Edit::Input, "", r.Stock.If(used), v.Type + R"(\s+)" + v.Name);
  }
}

void ReplaceAll(std::string& text, const std::string& from, const std::string& to)
{
  for (size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
  {
    text.replace(at, from.size(), to);
  }
}

void FoldMaterial(const wfv::ShaderBuilder::Material& surface, std::string& fragment)
{
  const auto fold = [&fragment](bool known, const std::string& name, const std::string& value) {
    if (known)
    {
      stock::Replace(fragment, stock::Edit::MaterialUniform,
        "const float " + name + " = " + value + ";", stock::Found::May, name);
    }
  };
  fold(surface.NoAmbient, "ambientIntensity", "0.0");
  fold(surface.NoDiffuse, "diffuseIntensity", "0.0");
  fold(surface.FullDiffuse, "diffuseIntensity", "1.0");
  fold(surface.NoSpecular, "specularIntensity", "0.0");
  fold(surface.Opaque, "opacityUniform", "1.0");
}

std::string Define(const char* name, int value)
{
  return std::string("#define ") + name + " " + std::to_string(value) + "\n";
}

bool IsExact(const Request& r)
{
  return r.Triangles.ByRays || r.Stage == wfv::ShaderBuilder::Variant::Exact;
}

namespace
{
bool AllRayTested(const Request& r)
{
  return r.Kind == wfv::ShaderBuilder::Primitive::Triangles &&
    r.Stage != wfv::ShaderBuilder::Variant::Projected && IsExact(r);
}
}

bool NonCentral(const Request& r)
{
  return r.View.Stereo && !r.View.Stereo->Traits.OneCenter &&
    (AllRayTested(r) || line::Draws(r) || line::DrawsChords(r));
}

bool NonCentralImpostors(const Request& r)
{
  return r.View.Stereo && !r.View.Stereo->Traits.OneCenter && quadric::Draws(r.Kind);
}

bool CurvedRays(const Request& r)
{
  return r.View.Stereo && !r.View.Stereo->Traits.StraightRays && AllRayTested(r);
}

std::string ViewSource(const Request& r)
{
  const bool meridian = r.View.Projection->Axis == wfv::Family::Meridian;
  const bool faces = r.View.Projection->Axis == wfv::Family::Faces;
  const bool sampled = r.View.Projection->Axis == wfv::Family::Sampled;
  return "// WideFoV: what this program is for\n#define WFV_FN\n#define WFV_TABLES int\n" +
    Define("WFV_MERIDIAN", meridian) + Define("WFV_FACES", faces) + Define("WFV_SAMPLED", sampled) +
    Define("WFV_ROUND", r.View.Projection->Axis == wfv::Family::Azimuthal) +
    Define("WFV_STRAIGHT_SEAM", r.View.Projection->StraightSeam) +
    Define("WFV_FLAT_RIM", r.View.Projection->FlatRim) + Define("WFV_EXACT", IsExact(r)) +
    Define("WFV_BY_RAYS", r.Triangles.ByRays) + Define("WFV_FP64", r.Triangles.Fp64) +
    Define("WFV_DEPTH_MAPPING(v)", r.View.DepthMapping) +
    Define("WFV_MULTISAMPLE", r.View.Multisample) + Define("WFV_WIDE_LINES", r.Lines.Wide) +
    Define("WFV_EDGES", r.Triangles.Edges || r.DebugView) +
    Define("WFV_EDGE_FLAGS", r.Triangles.EdgeFlags) + Define("WFV_DEBUG_VIEW", r.DebugView) +
    "#define WFV_TILTED " + (r.View.Tilted ? "true" : "false") + "\n#define WFV_LENSED " +
    (r.View.Lensed ? "true" : "false") + "\n" + "#define WFV_FADES " +
    (r.View.Fades ? "true" : "false") + "\n" + "#define WFV_ANGLES " +
    (meridian ? "wfvMeridianAngles" : "wfvAzimuthalAngles") + "\n" +
    Define("WFV_NON_CENTRAL", NonCentral(r)) +
    Define("WFV_NON_CENTRAL_IMPOSTORS", NonCentralImpostors(r)) +
    Define("WFV_CURVED_RAYS", CurvedRays(r)) + Define("WFV_RUNS", r.Runs) +
    Define("WFV_SHIFTED", r.View.Stereo && !r.View.Stereo->Traits.StraightRays && !CurvedRays(r)) +
    wfv::MathGlsl() + wfv::CommonGlsl() + wfv::DepthGlsl() + limits_glsl +
    (r.View.Stereo ? ray_hit_glsl + r.View.Stereo->Glsl : "") + (sampled ? directions_glsl : "") +
    r.View.Projection->Glsl + interface_glsl;
}

std::string EdgeSource()
{
  return std::string(preclip_glsl) + edge_singular_glsl + edge_error_glsl;
}

std::string RaySource(const Request& r)
{
  const bool cylinder =
    r.View.Projection->Axis == wfv::Family::Meridian && r.View.Projection->StraightSeam;
  const bool sampled = r.View.Projection->Axis == wfv::Family::Sampled;
  return std::string(cylinder ? ray_cylinder_glsl : "") + ray_fragment_glsl +
    (sampled ? ray_steps_sampled_glsl : ray_steps_glsl);
}

std::string Corner(size_t varying, int corner)
{
  return "wfvCorner" + std::to_string(varying) + "_" + std::to_string(corner);
}

std::string CornerOutputs(const std::vector<Varying>& varyings, int corners, const Known& known)
{
  std::string declarations;
  std::string body;
  for (size_t i = 0; i < varyings.size(); i++)
  {
    const Varying& v = varyings[i];
    if (known.count(v.Name) > 0)
    {
      continue;
    }
    declarations += v.Input();
    for (int c = v.Flat ? corners - 1 : 0; c < corners; c++)
    {
      declarations += "flat out " + v.Declaration(Corner(i, c));
      body += "  " + Corner(i, c) + " = " + v.Name + "[" + std::to_string(c) + "];\n";
    }
  }
  return "// WideFoV: outputs at the corners\n" + declarations + "void wfvWriteCorners()\n{\n" +
    body + "}\n";
}

std::string CornerInputs(
  const std::vector<Varying>& varyings, const std::vector<std::string>& weights, const Known& known)
{
  const int corners = static_cast<int>(weights.size());
  std::string declarations;
  std::string body;
  for (size_t i = 0; i < varyings.size(); i++)
  {
    const Varying& v = varyings[i];
    declarations += v.Declaration(v.Name);
    const auto value = known.find(v.Name);
    if (value != known.end())
    {
      body += "  " + v.Name + " = " + value->second + ";\n";
      continue;
    }
    std::string sum;
    for (int c = v.Flat ? corners - 1 : 0; c < corners; c++)
    {
      declarations += "flat in " + v.Declaration(Corner(i, c));
      sum += (sum.empty() ? "" : " + ") + (v.Flat ? "" : weights[c] + " * ") + Corner(i, c);
    }
    body += "  " + v.Name + " = " + sum + ";\n";
  }
  return "// WideFoV: what was output at the corners\n" + declarations +
    "void wfvInterpolate()\n{\n" + body + "}\n";
}

std::string MixedOutputs(const std::vector<Varying>& varyings, const std::string& parameter,
  const std::vector<std::string>& weights)
{
  std::string declarations;
  std::string body;
  for (const Varying& v : varyings)
  {
    // VTK itself renames the fragment stage's
    std::string out = v.Name;
    ReplaceAll(out, "VSOut", "GSOut");
    if (out == v.Name)
    {
      continue;
    }
    declarations += v.Input();
    declarations += (v.Flat ? "flat out " : "out ") + v.Declaration(out);
    std::string sum;
    const size_t corners = weights.size();
    for (size_t c = v.Flat ? corners - 1 : 0; c < corners; c++)
    {
      sum += (sum.empty() ? "" : " + ") + (v.Flat ? "" : weights[c] + " * ") + v.Name + "[" +
        std::to_string(c) + "]";
    }
    body += "  " + out + " = " + sum + ";\n";
  }
  return "// WideFoV: outputs between the corners\n" + declarations + "void wfvWriteMix(" +
    parameter + ")\n{\n" + body + "}\n";
}

int CornerComponents(const std::vector<Varying>& varyings, int corners, const Known& known)
{
  int count = 0;
  for (const Varying& v : varyings)
  {
    count += known.count(v.Name) > 0 ? 0 : v.Components() * (v.Flat ? 1 : corners);
  }
  return count;
}

namespace
{
void FoldLights(const std::string& constants, std::string& declarations)
{
  std::istringstream lines(constants);
  std::string name, value;
  while (lines >> name && std::getline(lines, value))
  {
    stock::Replace(declarations, stock::Edit::LightUniform,
      "const vec3 " + name + " =" + value + ";", stock::Found::May, name);
  }
}
}

void RewriteLights(const Request& r, std::string& fragment)
{
  using stock::Edit;
  const bool lit = r.Stock.Light != stock::Lit::No;
  const bool alone = r.Stock.Light == stock::Lit::Headlight;
  // the first statement of the stock main, whatever main is called by now
  const size_t inside = stock::Look(fragment, Edit::LightPlace, r.Stock.If(lit)).At;
  if (inside == std::string::npos)
  {
    return;
  }
  std::string head = fragment.substr(0, inside);
  std::string body = fragment.substr(inside);
  FoldLights(r.Lights.Constants ? *r.Lights.Constants : "", head);
  wfv::ShaderBuilder::Declare(head, light_fragment_glsl);
  ReplaceAll(head, "uniform int wfvHeadlights;",
    "const int wfvHeadlights = " + std::to_string(r.Lights.Headlights) + ";");
  stock::Replace(body, Edit::LightPlace, "$&\n  wfvFromEye = WFV_FROM_EYE;");
  stock::Replace(body, Edit::HeadlightCosine, "max($1, dot(normalVCVSOutput, -wfvFromEye))",
    r.Stock.If(alone && !r.Stock.Physical));
  stock::Replace(body, Edit::LightDirection, "wfvLightDirection($1, lightDirectionVC$1)",
    r.Stock.If(lit && !alone));
  stock::Replace(
    body, Edit::LineFacing, "if (dot(normalVCVSOutput, wfvFromEye) > 0.0)", stock::Found::May);
  fragment = head + body;
}

void RewriteFlatNormal(const Request& r, std::string& fragment)
{
  const bool flat = r.Stock.Light != stock::Lit::No && !r.Stock.Normals && !r.Stock.Wireframe;
  stock::Replace(fragment, stock::Edit::FlatNormal, "wfvFlatNormal()", r.Stock.If(flat));
}

std::string TakeFromEye(const Request& r, std::string& vertex, bool keepModel)
{
  const bool both = vertex.find("MCDCMatrix") != std::string::npos;
  std::string matrix = both ? "MCDCMatrix" : "MCVCMatrix";
  if (stock::Replace(vertex, stock::Edit::FromEye, "wfvFromEyeOf(" + matrix + ", vertexMC)",
        r.Stock.If(!r.Stock.Glyphs)) < 0)
  {
    return "";
  }
  wfv::ShaderBuilder::Declare(vertex, Define("WFV_MODEL", keepModel) + eye_vertex_glsl);
  return matrix;
}

void RewriteOffset(std::string& fragment)
{
  stock::Replace(fragment, stock::Edit::DepthOffsetValue, "wfvOffsetOfDepth(gl_FragCoord.z, $&)",
    stock::Found::May);
}

std::string RewriteDepth(const Request& r, std::string& fragment)
{
  RewriteOffset(fragment);
  stock::Replace(fragment, stock::Edit::FragmentDepth, "wfvDepth", stock::Found::May);
  // the stock template names gl_FragDepth in a comment; only a value given counts
  static const std::regex setsDepth(R"(gl_FragDepth\s*=)");
  const bool sets = std::regex_search(fragment, setsDepth);
  // depth peeling, where it comes later, would put the depth of the covering shape here
  stock::Replace(fragment, stock::Edit::DepthPlace, "", r.Stock.If(!sets));
  if (sets)
  {
    return "";
  }
  return r.Kind == Primitive::Triangles
    ? "  gl_FragDepth = wfvDepth + wfvPolygonOffsetAt(wfvDepth);\n"
    : "  gl_FragDepth = wfvDepth;\n";
}
}
}

void wfv::ShaderBuilder::Declare(std::string& source, const std::string& text)
{
  // what has any of VTK's tags has this one; what has none begins with the text
  const bool tags = source.find("//VTK::") != std::string::npos;
  const wfv::stock::Found found = tags ? wfv::stock::Found::Must : wfv::stock::Found::May;
  const size_t at = wfv::stock::Look(source, wfv::stock::Edit::Declarations, found).At;
  source.insert(at != std::string::npos ? source.find('\n', at) + 1 : 0, text);
}
