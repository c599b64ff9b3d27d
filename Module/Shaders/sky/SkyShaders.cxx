// SPDX-License-Identifier: BSD-3-Clause
#include "Shaders/sky/SkyShaders.h"

#include "Compat/StockEdits.h"
#include "Shaders/ShaderText.h"
#include "WideFoVGlsl.h"

namespace wfv
{
namespace sky
{
using stock::Edit;

namespace
{
using Request = ShaderBuilder::Request;

// What both need of the view.
std::string RaySource(const Request& r, Kind kind)
{
  const bool shifted = r.View.Stereo && r.View.Stereo->Traits.OneCenter;
  return "#extension GL_ARB_sample_shading : enable\n" + shader::ViewSource(r) +
    shader::Define("WFV_SKY_SHIFTED", shifted) + "#define WFV_SKY_HALVES " +
    (kind == Kind::Halves ? "true" : "false") + "\n" + shader::RaySource(r) + sky_fragment_glsl;
}

// Of the floor; its texture had one size before VTK 9.4.
std::string EditFloor(const Request& r, std::string& fragment)
{
  const int lookup =
    stock::Replace(fragment, Edit::SkyFloorLookup, "wfvSkyFloor(actortexture, dirv, pos, t)");
  stock::Replace(fragment, Edit::SkyFloorEye, "p0 - wfvSkyEye");
  stock::Replace(fragment, Edit::SkyFloorDepth, "gl_FragDepth = wfvSkyDepth(t);");
  const bool own = r.View.Stereo && !r.View.Stereo->Traits.OneCenter;
  return std::string("#define WFV_SKY_EYE(d) ") + (own ? "wfvEyeAt(d, wfvView)" : "vec3(0.0)") +
    "\n#define WFV_SKY_TILE " + (lookup == 1 ? "floorTCoordScale" : "vec2(1.0)") + "\n" +
    sky_floor_glsl;
}

// Of what is at infinity.
void EditSky(Kind kind, std::string& fragment)
{
  stock::Replace(fragment, Edit::SkyLookup, "wfvSkyTexture(actortexture,");
  if (kind == Kind::Halves)
  {
    stock::Replace(fragment, Edit::SkyHalf, "wfvSkyHalf(leftEye)");
  }
}

// vtkWideFoVDataPass draws to more than the colour: there is nothing where the sky is.
std::string DataOf(const std::string& fragment)
{
  const bool writesData = fragment.find("wfvData(") != std::string::npos;
  return writesData ? "  gl_FragData[1] = vec4(0.0);\n  gl_FragData[2] = vec4(0.0);\n" : "";
}
}

std::string GradientSource(const Request& r)
{
  return "//VTK::System::Dec\n" + RaySource(r, Kind::Sphere) + "//VTK::Output::Dec\n" +
    sky_gradient_glsl;
}

void Finish(const Request& r, Kind kind, std::string& fragment)
{
  const bool floor = kind == Kind::Floor;
  const std::string after = DataOf(fragment) + "  if (wfvSkyHide) { discard; }\n" +
    (floor ? "" : "  gl_FragDepth = 1.0;\n");
  stock::Replace(fragment, Edit::SkyDirection, "wfvSkyDirection()");
  if (floor)
  {
    // VTK's uniforms are known by then
    stock::Replace(fragment, Edit::MainFunction, EditFloor(r, fragment) + "\n$&");
  }
  else
  {
    EditSky(kind, fragment);
  }
  ShaderBuilder::WrapMain(
    fragment, floor ? "  wfvPrepareFloor();\n" : "  wfvPrepareSky();\n", after);
  ShaderBuilder::Declare(fragment, RaySource(r, kind));
}
}
}
