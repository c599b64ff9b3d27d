// SPDX-License-Identifier: BSD-3-Clause
// The sky (vtkSkybox) by the ray of each pixel: a direction at infinity, the same for both eyes.
// Behind ray_fragment.glsl.
uniform mat3 wfvSkyToWorld; // from view coordinates
uniform vec3 wfvSkyFrom;    // world: their origin
uniform int wfvSkyMeans;    // 0: the texture has no mipmaps

// Of the pixel's centre, in the map's own frame.
WfvRay wfvSky = WfvRay(vec3(0.0, 0.0, -1.0), false);
mat2x3 wfvSkySteps = mat2x3(0.0); // how its direction changes from pixel to pixel, world
float wfvSkyLonger = 0.0;         // the longer one
bool wfvSkyHide = false;          // outside the map: background

// Pixels from the centre outwards, or inwards: as near to a border as that some of the pixel's
// samples may be on its other side.
const float WFV_SKY_RIM = 1.5;

vec3 wfvSkyTurned(vec3 direction)
{
  return wfvSkyToWorld * wfvUntilt(direction, wfvView);
}

// The ray through what is seen there at the depth (NDC).
WfvRay wfvSkyRayAt(vec2 offset, float depth)
{
#if WFV_SKY_SHIFTED
  vec2 ndc = wfvUnshift(wfvPlaceBeside(offset), depth, wfvView);
  WfvRay ray = wfvUnproject(ndc, wfvView);
#if WFV_SHIFTED
  ray.inside = ray.inside && abs(ndc.x) <= 1.0 && abs(ndc.y) <= 1.0; // where the volume ends
#endif
  return ray;
#else
  return wfvRayAt(offset);
#endif
}

// Sets which samples of the pixel are inside the map.
void wfvSkyCover(bool rim, float depth)
{
  bool centre = wfvSky.inside;
  wfvSkyHide = !centre;
#if WFV_MULTISAMPLE && defined(GL_ARB_sample_shading)
  vec2 outward = wfvNdcOfPixel(gl_FragCoord.xy) * wfvPicture.zw;
  outward *= (centre ? WFV_SKY_RIM : -WFV_SKY_RIM) / max(length(outward), 1e-6);
  int mask = centre ? -1 : 0;
  if (wfvSamples > 1 && (rim || wfvSkyRayAt(outward, depth).inside != centre))
  {
    mask = 0;
    for (int i = 0; i < wfvSamples; i++)
    {
      mask |= wfvSkyRayAt(wfvSampleOffsets[i], depth).inside ? 1 << i : 0;
    }
  }
  gl_SampleMask[0] = mask;
  wfvSkyHide = mask == 0;
#endif
}

#if WFV_SKY_SHIFTED
// The change of direction per pixel along one axis: the smaller one, for the map may be discontinuous on the
// one side or end there.
vec3 wfvSkyStep(vec2 axis, float depth)
{
  WfvRay next = wfvSkyRayAt(axis, depth);
  WfvRay before = wfvSkyRayAt(-axis, depth);
  vec3 a = next.direction - wfvSky.direction;
  vec3 b = wfvSky.direction - before.direction;
  bool second = !next.inside || (before.inside && dot(b, b) < dot(a, a));
  return second ? b : a;
}
#endif

void wfvPrepareSkyAt(float depth)
{
  wfvSky = wfvSkyRayAt(vec2(0.0), depth);
  bool rim;
#if WFV_SKY_SHIFTED
  rim = true;
  mat2x3 steps = mat2x3(wfvSkyStep(vec2(1.0, 0.0), depth), wfvSkyStep(vec2(0.0, 1.0), depth));
#else
  mat2x3 steps = wfvRaySteps(wfvSky, rim);
#endif
  wfvSkySteps = mat2x3(wfvSkyTurned(steps[0]), wfvSkyTurned(steps[1]));
  wfvSkyLonger = max(length(wfvSkySteps[0]), length(wfvSkySteps[1])) / length(wfvSkyToWorld[0]);
  wfvSkyCover(rim, depth);
}

void wfvPrepareSky()
{
  wfvPrepareSkyAt(1.0);
}

// World, unit length.
vec3 wfvSkyDirection()
{
  return normalize(wfvSkyTurned(wfvSky.direction));
}

// The level of a texture whose texels are as large as a pixel, where a unit of direction is so
// many of them. By the direction alone, so that there is no seam and no pole.
float wfvSkyLevel(float texels)
{
  return wfvSkyMeans != 0 ? log2(max(wfvSkyLonger * texels, 1.0)) : 0.0;
}

// A cube's. Of both functions VTK's level, which not every VTK names, is not used.
vec4 wfvSkyTexture(samplerCube faces, vec3 direction, float level)
{
  return textureLod(faces, direction, wfvSkyLevel(0.5 * float(textureSize(faces, 0).x)));
}

vec4 wfvSkyTexture(samplerCube faces, vec3 direction)
{
  return wfvSkyTexture(faces, direction, 0.0);
}

// A sphere's, or one of two in one texture, from this height on: it goes round, but not over the
// poles, where it would meet its other end.
float wfvSkyLow = 0.0;

float wfvSkyHalf(float leftEye)
{
  wfvSkyLow = 0.5 * leftEye;
  return 0.25 + wfvSkyLow;
}

vec4 wfvSkyTexture(sampler2D angles, vec2 place, float level)
{
  float height = WFV_SKY_HALVES ? 0.5 : 1.0;
  float texels = float(textureSize(angles, 0).y);
  float at = wfvSkyLevel(height * texels / WFV_PI);
  float half_ = min(0.5 * exp2(ceil(at)) / texels, 0.5 * height);
  float y = clamp(place.y, wfvSkyLow + half_, wfvSkyLow + height - half_);
  return textureLod(angles, vec2(place.x, y), at);
}
