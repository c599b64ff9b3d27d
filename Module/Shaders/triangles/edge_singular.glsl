// SPDX-License-Identifier: BSD-3-Clause
// Pre-clip: edges that come near to places which the map stretches without bound (behind preclip.glsl).

// True where the arc a, b (unit vectors) comes within asin(s) of the axis.
bool wfvNears(vec3 a, vec3 b, vec3 axis, float s)
{
  float c = sqrt(1.0 - s * s);
  if (dot(a, axis) > c || dot(b, axis) > c)
  {
    return true;
  }
  vec3 n = cross(a, b);
  float l = length(n);
  if (!(abs(dot(n, axis)) < s * l))
  {
    return false;
  }
  vec3 top = axis - n * (dot(axis, n) / (l * l));
  return dot(cross(a, top), n) > 0.0 && dot(cross(top, b), n) > 0.0;
}

// Sine of the angle round a singular point of the map inside which no chord is drawn:
// there a pixel no longer looks like a plane.
float wfvSingularSine()
{
#if !WFV_ROUND
  float pixel = 2.0 * wfvView.halfFov.y / (wfvViewport.w * wfvTile.y);
#else
  float pixel = 2.0 * wfvView.halfFov.x / (wfvViewport.z * wfvTile.x);
#endif
  return sin(clamp(WFV_SINGULAR_PIXELS * pixel, WFV_SINGULAR_ANGLE, 1.0));
}

// True where the arc comes that near to a point that the map stretches without bound.
bool wfvNearsSingularity(vec3 a, vec3 b)
{
  float s = wfvSingularSine();
#if WFV_FACES || WFV_SAMPLED
  return false;
#elif WFV_MERIDIAN
  return wfvNears(a, b, vec3(0.0, 1.0, 0.0), s) || wfvNears(a, b, vec3(0.0, -1.0, 0.0), s);
#else
  return wfvNears(a, b, vec3(0.0, 0.0, 1.0), s);
#endif
}

#if WFV_ROUND
// Cosine of the angle from the axis beyond which no edge is drawn as a chord: behind the
// rim of a round map, whence chords would cut across it, and beside a rim where the map is
// flat and pixels are no measure of angles.
float wfvChordEnd()
{
#if WFV_FLAT_RIM
  vec2 pixels = 0.5 * wfvViewport.zw * wfvTile.xy * wfvView.scale;
  float strip = WFV_SINGULAR_PIXELS / min(pixels.x, pixels.y);
  return cos(wfvTheta(max(0.0, wfvRadius(0.5 * WFV_PI, wfvView) - strip), wfvView));
#else
  return wfvView.maxAngle < 0.4999 * WFV_PI ? -2.0 : cos(wfvView.maxAngle);
#endif
}
#endif
