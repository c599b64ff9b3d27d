// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWideFoVQuadricShaders.h"

#include "WideFoVGlsl.h"
#include "vtkWideFoVShaderText.h"

#include <algorithm>

namespace wfv
{
namespace quadric
{
using namespace shader;

namespace
{
// Inputs that the stock fragment stage takes from its own geometry stage, or from the
// vertices where the surface itself is meant: the fragment stage sets them.
const std::vector<Varying>& OwnInputs()
{
  static const std::vector<Varying> own{ { false, "vec4", "vertexVCVSOutput" },
    { false, "vec3", "centerVCVSOutput" }, { false, "float", "radiusVCVSOutput" } };
  return own;
}

// How the inputs that stand for the surface follow from what the ray meets.
std::string SurfaceValue(const std::string& name)
{
  if (name == "vertexVCVSOutput")
  {
    return "vec4(wfvSurface, 1.0)";
  }
  return name == "wfvPositionVSOutput" ? "wfvSurface" : "";
}

bool IsOwn(const Varying& v)
{
  const auto same = [&v](const Varying& own) { return own.Name == v.Name; };
  return !SurfaceValue(v.Name).empty() || std::any_of(OwnInputs().begin(), OwnInputs().end(), same);
}

// Copies of the vertex outputs at the vertices of the primitive.
std::string CornerOutputs(const std::vector<Varying>& varyings)
{
  std::string declarations;
  std::string body;
  for (size_t i = 0; i < varyings.size(); i++)
  {
    const Varying& v = varyings[i];
    declarations += v.Input();
    if (!IsOwn(v))
    {
      declarations += "flat out " + v.Declaration(Corner(i, 0));
      body += "  " + Corner(i, 0) + " = " + v.Name + "[0];\n";
    }
  }
  return declarations + "void wfvWriteCorners()\n{\n" + body + "}\n";
}

std::string CornerInputs(const std::vector<Varying>& varyings)
{
  std::string declarations;
  std::string body;
  for (size_t i = 0; i < varyings.size(); i++)
  {
    const Varying& v = varyings[i];
    declarations += v.Declaration(v.Name);
    if (!IsOwn(v))
    {
      declarations += "flat in " + v.Declaration(Corner(i, 0));
    }
    const std::string value = IsOwn(v) ? SurfaceValue(v.Name) : Corner(i, 0);
    body += value.empty() ? "" : "  " + v.Name + " = " + value + ";\n";
  }
  return declarations + "void wfvInterpolate()\n{\n" + body + "}\n";
}

std::string KindDefines(const Request& r)
{
  return Define("WFV_ANGULAR",
           r.Projection->Axis == Family::Meridian || r.Projection->Axis == Family::Azimuthal) +
    "#define WFV_BALL_RADIUS radiusVCVSOutput[0] / wfvScale()\n";
}

// What the stock sphere mapper's two passes over translucent balls show.
std::string Side()
{
  return "opacityUniform >= 1.0 ? 0 : (invertedDepth < 0.0 ? -1 : 1)";
}

void FinishFragment(const Request& r, std::vector<Varying> varyings, std::string& fragment)
{
  const size_t fromVertex = varyings.size();
  for (const Varying& own : OwnInputs())
  {
    const auto same = [&own](const Varying& v) { return v.Name == own.Name; };
    if (std::none_of(varyings.begin(), varyings.begin() + fromVertex, same))
    {
      varyings.push_back(own);
    }
  }
  RemoveInputs(fragment, varyings);
  ReplaceAll(fragment, "gl_FragCoord.z", "wfvDepth");
  ReplaceAll(fragment, "gl_FrontFacing", "wfvFront");
  RewriteLights(fragment);
  const bool round = r.Projection->Axis == Family::Azimuthal;
  vtkWideFoVShaderBuilder::WrapMain(fragment,
    "  wfvPrepare(" + Side() + ");\n  gl_FragDepth = wfvDepth;\n",
    std::string("  if (wfvHide) { discard; }\n") +
      (round ? "  if (wfvOutsideDomain()) { discard; }\n" : ""));
  vtkWideFoVShaderBuilder::Declare(fragment,
    "#extension GL_ARB_sample_shading : enable\n" + ViewSource(r) + quadric_fragment_glsl +
      quadric_ball_glsl + CornerInputs(varyings) + (round ? domain_fragment_glsl : ""));
}
}

bool Draws(Primitive kind)
{
  return kind == Primitive::Spheres;
}

void Prepare(const Request&, std::string& geometry, std::string& fragment)
{
  geometry.clear();
  // the mapper's own meeting of its imposter with the ray, for a flat picture
  const size_t begin = fragment.find("  vec3 EyePos;");
  const std::string last = "gl_FragDepth = (pos.z / pos.w + 1.0) / 2.0;";
  const size_t end = fragment.find(last, std::min(begin, fragment.size()));
  if (end != std::string::npos)
  {
    fragment.replace(begin, end + last.size() - begin, "  vec3 normalVCVSOutput = wfvNormal;");
  }
}

void Finish(const Request& r, std::string& vertex, std::string& geometry, std::string& fragment)
{
  FlattenArrays(vertex, fragment);
  TakeFromEye(vertex);
  const std::vector<Varying> varyings = FindVaryings(vertex);
  geometry = "//VTK::System::Dec\n" + ViewSource(r) + KindDefines(r) + CornerOutputs(varyings) +
    quadric_cover_glsl + quadric_balls_glsl;
  FinishFragment(r, varyings, fragment);
}
}
}
