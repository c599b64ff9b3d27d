// SPDX-License-Identifier: BSD-3-Clause
// Radii given in pixels. A pixel of a wide map is no square of angles, and not the same
// everywhere; here it stands for the square of the same solid angle. So a sphere drawn for
// a point of n pixels covers the area of a disc of n pixels wherever it lies, and a tube
// is n pixels wide where the map keeps shapes. The radius belongs to the point alone:
// segments of a polyline meet in the same sphere.

uniform float wfvPixels; // diameter

// Angle round a pole or the rim inside which the pixel of this distance counts: on it,
// a pixel may have no solid angle at all. Radians.
const float WFV_RIM_ANGLE = 0.01;

// Step of the differences, radians on the sphere: two of them stay inside that distance.
const float WFV_ANGLE_STEP = 0.005;

// The longest step of an azimuth, radians: near a pole, where it is short on the sphere.
const float WFV_AZIMUTH_STEP = 0.1;

#if WFV_ANGULAR
// The derivative of the map along an angle, by differences of fourth order: near a pole
// maps curve within a few steps.
vec2 wfvMapSlope(vec2 a, vec2 h)
{
  vec2 near = wfvMap(a + h, wfvView) - wfvMap(a - h, wfvView);
  vec2 far = wfvMap(a + 2.0 * h, wfvView) - wfvMap(a - 2.0 * h, wfvView);
  return (8.0 * near - far) / (12.0 * (h.x + h.y));
}
#endif

// Side, in radians, of the square of a pixel's solid angle, at the direction of p.
float wfvPixelAngle(vec3 p)
{
  vec2 size = wfvViewport.zw * wfvTile.xy;
  float mean = sqrt(4.0 * WFV_PI / (size.x * size.y));
#if WFV_ANGULAR
  vec2 a = WFV_ANGLES(p);
  vec2 all = wfvPolarRange();
#if !WFV_MERIDIAN
  all.y = min(all.y, wfvView.maxAngle);
#endif
  a.y = clamp(a.y, all.x + WFV_RIM_ANGLE, all.y - WFV_RIM_ANGLE);
#if WFV_MERIDIAN
  float element = cos(a.y);
#else
  float element = sin(a.y);
#endif
  float turn = min(WFV_ANGLE_STEP / element, WFV_AZIMUTH_STEP);
  vec2 dx = 0.5 * size * wfvMapSlope(a, vec2(turn, 0.0));
  vec2 dy = 0.5 * size * wfvMapSlope(a, vec2(0.0, WFV_ANGLE_STEP));
  float side = sqrt(element / abs(dx.x * dy.y - dx.y * dy.x));
  return side > 0.0 && side < 1.0 ? side : mean;
#else
  return mean;
#endif
}

// Radius of a sphere at p that is wfvPixels wide: less than its distance from the eye.
float wfvPixelRadius(vec3 p)
{
  return wfvLength(p) * sin(min(0.5 * wfvPixels * wfvPixelAngle(p), 1.5));
}
