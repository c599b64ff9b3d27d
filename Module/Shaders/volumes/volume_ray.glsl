// SPDX-License-Identifier: BSD-3-Clause
// Behind VTK's text of a volume: the ray of the pixel, and where it meets the box.

// Stands for a component of a ray that is none: what is divided by it stays finite in float32.
const float WFV_LEAST_STEP = 1e-25;

// To the eye, in coordinates of the data of an input.
vec3 wfvToEye(int input_)
{
#if WFV_MATRICES > 1
  return -normalize((in_inverseVolumeMatrix[input_ + 1] *
    in_inverseModelViewMatrix * vec4(wfvFromEye, 0.0)).xyz);
#else
  return -wfvRayOfData;
#endif
}

float wfvNoZero(float x)
{
  return abs(x) < WFV_LEAST_STEP ? WFV_LEAST_STEP : x;
}

// Where the line from, in texture coordinates, along step is inside the box: from x to y steps.
vec2 wfvInsideBox(vec3 from, vec3 step_)
{
  vec3 s = vec3(wfvNoZero(step_.x), wfvNoZero(step_.y), wfvNoZero(step_.z));
  vec3 a = (in_texMin[0] - from) / s;
  vec3 b = (in_texMax[0] - from) / s;
  vec3 first = min(a, b);
  vec3 last = max(a, b);
  return vec2(max(first.x, max(first.y, first.z)), min(last.x, min(last.y, last.z)));
}

#if !WFV_CURVES
// Sets what volume_fragment.glsl declares; false where this pixel sees nothing of the box.
bool wfvMeetVolume()
{
  WfvRay ray = wfvRayAt(vec2(0.0));
  wfvFromEye = wfvUntilt(ray.direction, wfvView);
#if WFV_VOLUME_EYES
  wfvStart = wfvUntilt(wfvEyeAt(ray.direction, wfvView), wfvView);
#endif
  mat4 toData = in_inverseVolumeMatrix[0] * in_inverseModelViewMatrix;
  ip_inverseTextureDataAdjusted = in_cellToPoint[0] * in_inverseTextureDatasetMatrix[0];
  vec3 start = (toData * vec4(wfvStart, 1.0)).xyz;
  vec3 step_ = (toData * vec4(wfvFromEye, 0.0)).xyz;
  vec3 textureStart = (ip_inverseTextureDataAdjusted * vec4(start, 1.0)).xyz;
  vec3 textureStep = (ip_inverseTextureDataAdjusted * vec4(step_, 0.0)).xyz;
  vec2 inside = wfvInsideBox(textureStart, textureStep);
  float entry = max(inside.x, wfvView.radii.x);
  wfvDepth = wfvDepthOf(entry, wfvView);
  wfvRayOfData = normalize(step_);
  ip_vertexPos = start + entry * step_;
  ip_textureCoords = clamp(textureStart + entry * textureStep, in_texMin[0], in_texMax[0]);
  return ray.inside && entry < min(inside.y, wfvView.radii.y);
}
#endif
