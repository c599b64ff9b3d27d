// SPDX-License-Identifier: BSD-3-Clause
// Fragment side of volumes: what VTK's text takes from the faces of the box, from the eye and from
// its matrices, by the ray of the pixel. VTK marches along it. volume_ray.glsl sets these, behind
// VTK's own uniforms.

// As VTK's vertex stage would hand them on, of the place where the ray enters.
vec3 ip_textureCoords = vec3(0.0);
vec3 ip_vertexPos = vec3(0.0);
mat4 ip_inverseTextureDataAdjusted = mat4(1.0);

float wfvDepth = 0.0; // window depth of that place, 0 to 1
vec3 wfvStart = vec3(0.0);     // where the ray begins, view coordinates
vec3 wfvFromEye = vec3(0.0);   // its direction, unit length
vec3 wfvRayOfData = vec3(0.0); // the same in coordinates of the data

// Window depth of what is behind the eye: beyond every surface.
const float WFV_BEHIND_EYE = 2.0;

vec3 computeRayDirection()
{
  return wfvRayOfData;
}

// The place on the ray of this pixel at a window depth. The wide camera's normalized device
// coordinates are view coordinates.
vec4 WindowToNDC(const float x, const float y, const float depth)
{
  return vec4(wfvStart + wfvDistanceAt(depth, wfvView) * wfvFromEye, 1.0);
}

// Pixel and window depth of a place on the ray of this pixel.
vec4 NDCToWindow(const float x, const float y, const float z)
{
  float rho = dot(vec3(x, y, z) - wfvStart, wfvFromEye);
  return vec4(gl_FragCoord.xy, rho > 0.0 ? wfvDepthOf(rho, wfvView) : WFV_BEHIND_EYE, 1.0);
}

// Behind VTK's uniforms (volume_ray.glsl, volume_light.glsl).
vec3 wfvToEye(int input_);
vec3 wfvVolumeLight(int light, vec3 direction);

#if WFV_CURVES
vec3 wfvStraight = vec3(0.0); // where VTK's line is, texture coordinates

// Behind VTK's uniforms (volume_curve.glsl).
bool wfvSkipsSample();
bool wfvHasLeft();

// VTK cuts a line by its clipping planes; here each sample is asked.
bool AdjustSampleRangeForClipping(vec3 first, vec3 last)
{
  return true;
}
#endif
