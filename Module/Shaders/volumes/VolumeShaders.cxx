// SPDX-License-Identifier: BSD-3-Clause
#include "Shaders/volumes/VolumeShaders.h"

#include "Compat/StockEdits.h"
#include "Shaders/ShaderText.h"
#include "WideFoVGlsl.h"

#include <cstdlib>

namespace wfv
{
namespace volume
{
using namespace shader;
using stock::Edit;
using stock::Found;

namespace
{
bool Has(const std::string& text, const char* part)
{
  return text.find(part) != std::string::npos;
}

// Matrices of data in the text: one, or one more than there are inputs.
int CountMatrices(const std::string& fragment)
{
  const std::string declaration = "uniform mat4 in_volumeMatrix[";
  const std::size_t at = fragment.find(declaration);
  return at == std::string::npos ? 1 : std::atoi(fragment.c_str() + at + declaration.size());
}

// What VTK's vertex stage hands on, which the fragment stage now finds itself.
void TakeInputs(Found found, std::string& fragment)
{
  for (const char* const input : { R"(vec3\s+ip_textureCoords)", R"(vec3\s+ip_vertexPos)",
         R"(mat4\s+ip_inverseTextureDataAdjusted)" })
  {
    stock::Replace(fragment, Edit::Input, "", found, input);
  }
}

// By one headlight alone, which has variables of its own, or by others: how VTK counts them depends
// on those that it had before.
Found IfShaded(const Traits& traits, const std::string& fragment, const char* variable)
{
  return traits.Known && traits.Shaded && Has(fragment, variable) ? Found::Must : Found::May;
}

Found IfByHeadlight(const Traits& traits, const std::string& fragment)
{
  return IfShaded(traits, fragment, "vec3 g_ldir[");
}

// Lights at the eye, which VTK takes for parallel to the view axis. 9.1 has all lights in the
// renderer's order; since 9.2 those with a position come first. Returns what the text then calls.
std::string RewriteLights(const Request& r, const Traits& traits, std::string& fragment)
{
  stock::Replace(fragment, Edit::VolumeToEye, "wfvToEye($1)", IfByHeadlight(traits, fragment));
  const int wording = stock::Replace(fragment, Edit::VolumeLight,
    "wfvVolumeLight($1, in_lightDirection[$1])", IfShaded(traits, fragment, "g_fragWorldPos /="));
  if (wording < 0)
  {
    return "";
  }
  return Define("WFV_VOLUME_LIGHTS", wording == 0 ? r.Lights.Headlights : traits.Directional) +
    Define("WFV_POSITIONAL_FIRST", wording != 0) + volume_light_glsl;
}

bool Curves(const Request& r)
{
  return r.View.Stereo && !r.View.Stereo->Traits.StraightRays;
}

// Where a pixel sees along a curve: samples are moved there.
std::string RewriteMarch(Found must, std::string& fragment)
{
  stock::Replace(fragment, Edit::VolumeSkip, "g_skip = wfvSkipsSample();", must);
  stock::Replace(fragment, Edit::VolumeAdvance, "g_dataPos = wfvStraight + g_dirStep;", must);
  stock::Replace(fragment, Edit::VolumeLeave, "if (wfvHasLeft())", must);
  const bool clips = Has(fragment, "in_clippingPlanes");
  stock::Replace(
    fragment, Edit::VolumeClip, "bool wfvStockAdjustSampleRange(", clips ? must : Found::May);
  const bool slice = Has(fragment, "in_slicePlaneNormal");
  return Define("WFV_SLICES", slice) + Define("WFV_CLIPS", clips) +
    Define("WFV_HEADLIGHT", Has(fragment, "vec3 g_ldir[")) + curved_ray_glsl + volume_curve_glsl +
    (slice ? curve_slice_glsl : curve_sample_glsl);
}
}

void Finish(const Request& r, const Traits& traits, std::string& geometry, std::string& fragment)
{
  const Found must = traits.Known ? Found::Must : Found::May;
  TakeInputs(must, fragment);
  stock::Replace(fragment, Edit::VolumeRay, "vec3 wfvStockRayDirection()", must);
  stock::Replace(fragment, Edit::VolumePlace, "vec4 wfvStockWindowToNDC(", must);
  stock::Replace(fragment, Edit::VolumeWindow, "vec4 wfvStockNDCToWindow(", must);
  stock::Replace(fragment, Edit::FragmentDepth, "wfvDepth", Found::May);
  stock::Replace(
    fragment, Edit::VolumeDepthPass, "g_rayOrigin = ip_textureCoords.xyz;", Found::May);
  stock::Replace(fragment, Edit::VolumeImageDepth,
    "$&\n    depthValue.z = 2.0 * NDCToWindow(depthValue.x, depthValue.y, depthValue.z).z - 1.0;",
    Found::May);
  const std::string lights = RewriteLights(r, traits, fragment);
  const std::string march = Curves(r) ? RewriteMarch(must, fragment) : "";
  const int matrices = CountMatrices(fragment);
  const bool eyes = r.View.Stereo && r.View.Stereo->Traits.StraightRays;
  // declared first, for what it replaces is called all over the text; the rest has VTK's uniforms
  wfv::ShaderBuilder::Declare(fragment,
    ViewSource(r) + Define("WFV_CURVES", Curves(r)) + RaySource(r) + volume_fragment_glsl);
  fragment += "\n" + Define("WFV_MATRICES", matrices) + Define("WFV_VOLUME_EYES", eyes) +
    volume_ray_glsl + lights + march;
  wfv::ShaderBuilder::WrapMain(
    fragment, "  if (wfvMeetVolume())\n  {\n", "  }\n  else\n  {\n    discard;\n  }\n");
  geometry = "//VTK::System::Dec\n" + ViewSource(r) + volume_geometry_glsl;
}

void FinishFlat(const Traits& traits, std::string& fragment)
{
  const Found must = traits.Known ? Found::Must : Found::May;
  if (stock::Replace(fragment, Edit::VolumeRay, "vec3 wfvStockRayDirection()", must) < 0)
  {
    return;
  }
  stock::Replace(
    fragment, Edit::VolumeToEye, "(-computeRayDirection())", IfByHeadlight(traits, fragment));
  wfv::ShaderBuilder::Declare(fragment, "vec3 computeRayDirection();\n");
  fragment += std::string("\n") + volume_flat_glsl;
}
}
}
