// SPDX-License-Identifier: BSD-3-Clause
// Radii given in pixels. A pixel of a wide map is no square of angles, and not the same
// everywhere; here it stands for the square of the same solid angle. So a ball drawn for
// a point of n pixels covers the area of a disc of n pixels wherever it lies, and a tube
// is n pixels wide where the map keeps shapes. The radius belongs to the point alone:
// segments of a polyline meet in the same ball.

uniform float wfvPixels; // diameter

// Angle round a pole or the rim inside which the pixel of this distance counts: on it,
// a pixel may have no solid angle at all. Radians.
const float WFV_RIM_ANGLE = 0.01;

// Step of the central differences, radians.
const float WFV_ANGLE_STEP = 0.005;

// Side, in radians, of the square of a pixel's solid angle, at the direction of p.
float wfvPixelAngle(vec3 p)
{
  vec2 size = wfvViewport.zw * wfvTile.xy;
  float mean = sqrt(4.0 * WFV_PI / (size.x * size.y));
#if WFV_ANGULAR
  vec2 a = WFV_ANGLES(p);
  vec2 all = wfvPolarRange();
#if WFV_MERIDIAN
  a.x = clamp(a.x, WFV_RIM_ANGLE - WFV_PI, WFV_PI - WFV_RIM_ANGLE);
#else
  all.y = min(all.y, wfvView.maxAngle);
#endif
  a.y = clamp(a.y, all.x + WFV_RIM_ANGLE, all.y - WFV_RIM_ANGLE);
  vec2 dx = wfvMap(a + vec2(WFV_ANGLE_STEP, 0.0), wfvView) -
    wfvMap(a - vec2(WFV_ANGLE_STEP, 0.0), wfvView);
  vec2 dy = wfvMap(a + vec2(0.0, WFV_ANGLE_STEP), wfvView) -
    wfvMap(a - vec2(0.0, WFV_ANGLE_STEP), wfvView);
  dx *= 0.25 * size / WFV_ANGLE_STEP;
  dy *= 0.25 * size / WFV_ANGLE_STEP;
  float area = abs(dx.x * dy.y - dx.y * dy.x);
#if WFV_MERIDIAN
  float side = sqrt(cos(a.y) / area);
#else
  float side = sqrt(sin(a.y) / area);
#endif
  return side > 0.0 && side < 1.0 ? side : mean;
#else
  return mean;
#endif
}

// Radius of a ball at p that is wfvPixels wide: less than its distance from the eye.
float wfvPixelRadius(vec3 p)
{
  return wfvLength(p) * sin(min(0.5 * wfvPixels * wfvPixelAngle(p), 1.5));
}
