// SPDX-License-Identifier: BSD-3-Clause
// Behind volume_ray.glsl, where a pixel sees along a curve. VTK's text goes on along a line from
// the eye, the one through the place where the curve enters the box; each sample is taken where
// the curve is as far from the eye.

uniform vec2 wfvVolumeRange; // distances of the nearest and of the farthest point of the volume's bounds

const int WFV_CURVE_STEPS = 8192;   // at most, in looking for the box
const int WFV_CURVE_BISECTIONS = 24; // to float32's end

float wfvEntry = 0.0;         // distance of the place where the curve enters
float wfvWay = 1.0;           // distance between two samples

// The place of the curve at a distance, view coordinates; inside: of the picture's volume.
vec3 wfvCurveAt(float rho, out bool inside)
{
  float depth = clamp(2.0 * wfvDepthOf(rho, wfvView) - 1.0, -1.0, 1.0);
  WfvRay ray = wfvRayOfDepth(wfvPlaceBeside(vec2(0.0)), depth);
  inside = ray.inside;
  return rho * wfvUntilt(ray.direction, wfvView);
}

vec3 wfvTextureOf(vec3 place)
{
  return (ip_inverseTextureDataAdjusted * in_inverseVolumeMatrix[0] * in_inverseModelViewMatrix *
    vec4(place, 1.0)).xyz;
}

bool wfvIsInBox(float rho)
{
  bool inside;
  vec3 t = wfvTextureOf(wfvCurveAt(rho, inside));
  return inside && all(greaterThanEqual(t, in_texMin[0])) && all(lessThanEqual(t, in_texMax[0]));
}

#if WFV_SLICES
// Which side of the plane that cuts the volume.
bool wfvIsBefore(float rho)
{
  bool inside;
  vec4 place = in_inverseModelViewMatrix * vec4(wfvCurveAt(rho, inside), 1.0);
  return dot(in_slicePlaneNormal, place.xyz - in_slicePlaneOrigin) < 0.0;
}
#endif

// The distance, between two, at which the curve comes into the box, or, of slices, crosses the
// plane inside the box.
float wfvRefine(float before, float behind)
{
  for (int i = 0; i < WFV_CURVE_BISECTIONS; i++)
  {
    float middle = 0.5 * (before + behind);
#if WFV_SLICES
    bool back = wfvIsBefore(middle) == wfvIsBefore(behind);
#else
    bool back = wfvIsInBox(middle);
#endif
    behind = back ? middle : behind;
    before = back ? before : middle;
  }
  return behind;
}

// Sets wfvEntry; false where the curve meets nothing.
bool wfvFindEntry(float first, float last)
{
  float before = first;
#if WFV_SLICES
  bool side = wfvIsBefore(first);
#endif
  for (int i = 0; i < WFV_CURVE_STEPS && before < last; i++)
  {
    float here = min(first + float(i) * wfvWay, last);
    bool met = wfvIsInBox(here);
#if WFV_SLICES
    met = met && wfvIsBefore(here) != side;
    side = wfvIsBefore(here);
#endif
    if (met)
    {
      wfvEntry = i == 0 ? here : wfvRefine(before, here);
      return true;
    }
    before = here;
  }
  return false;
}

// Sets what volume_fragment.glsl declares; false where this pixel sees nothing of the box.
bool wfvMeetVolume()
{
  ip_inverseTextureDataAdjusted = in_cellToPoint[0] * in_inverseTextureDatasetMatrix[0];
  mat4 toData = in_inverseVolumeMatrix[0] * in_inverseModelViewMatrix;
  float first = max(wfvVolumeRange.x, wfvView.radii.x);
  bool inside;
  vec3 ahead = wfvCurveAt(first, inside) / first;
  wfvWay = in_sampleDistance / length((toData * vec4(ahead, 0.0)).xyz);
  if (!wfvFindEntry(first, min(wfvVolumeRange.y, wfvView.radii.y)))
  {
    return false;
  }
  vec3 place = wfvCurveAt(wfvEntry, inside);
  wfvFromEye = place / wfvEntry;
  wfvDepth = wfvDepthOf(wfvEntry, wfvView);
  vec3 step_ = (toData * vec4(wfvFromEye, 0.0)).xyz;
  wfvRayOfData = normalize(step_);
  wfvWay = in_sampleDistance / length(step_);
#if WFV_SLICES
  ip_vertexPos = (toData * vec4(wfvView.radii.x * wfvFromEye, 1.0)).xyz;
#else
  ip_vertexPos = (toData * vec4(place, 1.0)).xyz;
#endif
  ip_textureCoords = wfvTextureOf(place);
  return true;
}

// Distance of the sample of VTK's line.
float wfvSampleDistance()
{
  return wfvEntry + wfvWay * dot(g_dataPos - ip_textureCoords, g_dirStep) / dot(g_dirStep, g_dirStep);
}

// Behind the box, whatever the curve does.
bool wfvHasLeft()
{
  return wfvSampleDistance() > min(wfvVolumeRange.y, wfvView.radii.y);
}
