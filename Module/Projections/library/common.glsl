// SPDX-License-Identifier: BSD-3-Clause
// Shared by every projection. GLSL 3.30 that also compiles as C++ with GLM
// (ProjectionMath.h): no swizzles, no float suffixes, no out parameters.
//
// Frames: view coordinates (x right, y up, looking down -z) and normalized
// device coordinates (x right, y up, [-1, 1]). Angles in radians. WFV_FN is nothing
// in GLSL and "inline" in C++.

const float WFV_PI = 3.14159265358979323846;

// What stands for "infinitely far outside" in NDC: finite in float32 after any scale.
const float WFV_FAR_NDC = 1e30;

// The border of a map belongs to it: a point within one step of float32 beyond the
// border is on it.
const float WFV_BORDER = 1.0000001;

// Sine of the angle from a pole or the antipode that stands for none: it still tells the
// azimuths apart, which are places of their own where the map makes a line of the point.
const float WFV_AT_SINGULARITY = 1e-20;

// Radians from a pole or the antipode, within which no chord stands for an edge.
const float WFV_SINGULAR_ANGLE = 0.035;

// Whose view it is: of one of two eyes, or of the place between them.
const int WFV_EYE_LEFT = -1;
const int WFV_EYE_MIDDLE = 0;
const int WFV_EYE_RIGHT = 1;

// One view, as the shaders and the CPU share it.
struct WfvView
{
  vec2 halfFov;  // half the horizontal and vertical field of view, radians
  vec2 scale;    // NDC per unit of the raw map
  vec2 tilt;     // cosine and sine of the tilt about x
  vec2 radii;    // radii of the near and far clip spheres, scene units
  vec4 lens;     // c1 .. c4 of r = c1 t + .. + c9 t^9 (lens.glsl); all 0: the ideal lens
  float lens5;   // c5
  vec4 lensHigh; // c6 .. c9
  vec2 center;   // NDC of the axis of a round map, whose own coordinates begin there
  float maxAngle; // round maps: angle at the rim of the domain, radians
  int depthMapping; // WFV_DEPTH_LINEAR, ... (depth.glsl)
  float curvature; // how far chords are from their edges: see Curvature.h
  int eye;        // WFV_EYE_LEFT, ...
  float halfEyes; // half the distance between the eyes, in the unit of their stereo model
  vec4 stereo;    // what else the model knows of both, as it says (Stereo/*.glsl)
  vec4 tables;    // direction map: its width and height, cells along a cube's face, longest step
  WFV_TABLES map; // direction map: its tables, in C++; the shaders have textures
};

// The answer of wfvUnproject: a unit direction, or "outside the map".
struct WfvRay
{
  vec3 direction;
  bool inside;
};

// NDC without infinities, and without NaN on the C++ side.
WFV_FN vec2 wfvFinite(vec2 ndc)
{
  return vec2(max(-WFV_FAR_NDC, min(WFV_FAR_NDC, ndc.x)), max(-WFV_FAR_NDC, min(WFV_FAR_NDC, ndc.y)));
}

// 1 - x^2 - y^2 with little rounding beside the unit circle, where a map that is flat there
// has only these digits to tell angles by. At least 0.
WFV_FN float wfvInsideCircle(vec2 p)
{
  float big = max(abs(p.x), abs(p.y));
  float small = min(abs(p.x), abs(p.y));
  return max(0.0, (1.0 - big) * (1.0 + big) - small * small);
}

// Raises the axis of the projection by the tilt from -z towards +y. WFV_TILTED is false in a
// shader of a view without one.
WFV_FN vec3 wfvTilt(vec3 p, WfvView v)
{
  if (!WFV_TILTED)
  {
    return p;
  }
  return vec3(p.x, v.tilt.x * p.y + v.tilt.y * p.z, v.tilt.x * p.z - v.tilt.y * p.y);
}

WFV_FN vec3 wfvUntilt(vec3 p, WfvView v)
{
  if (!WFV_TILTED)
  {
    return p;
  }
  return vec3(p.x, v.tilt.x * p.y - v.tilt.y * p.z, v.tilt.x * p.z + v.tilt.y * p.y);
}

// Longitude lambda in (-pi, pi] from -z towards +x, latitude phi in [-pi/2, pi/2].
WFV_FN vec2 wfvMeridianAngles(vec3 p)
{
  return vec2(wfvAtan2(p.x, -p.z), wfvAtan2(p.y, wfvHypot(p.x, p.z)));
}

// The direction of a longitude and a latitude, of each the sine and the cosine.
WFV_FN vec3 wfvMeridianDirectionOf(vec2 lambda, vec2 phi)
{
  return vec3(phi.y * lambda.x, phi.x, -phi.y * lambda.y);
}

WFV_FN vec3 wfvMeridianDirection(vec2 a)
{
  return wfvMeridianDirectionOf(wfvSinCos(a.x), wfvSinCos(a.y));
}

// Azimuth about -z from +x towards +y, and the angle theta in [0, pi] from -z.
WFV_FN vec2 wfvAzimuthalAngles(vec3 p)
{
  return vec2(wfvAtan2(p.y, p.x), wfvAtan2(wfvHypot(p.x, p.y), -p.z));
}

WFV_FN vec3 wfvAzimuthalDirection(vec2 a)
{
  vec2 azimuth = wfvSinCos(a.x);
  vec2 theta = wfvSinCos(a.y);
  return vec3(theta.x * azimuth.y, theta.x * azimuth.x, -theta.y);
}

// The ray d of a place x to the right of the middle of a map that ends at lambda = +-pi. Beside
// that border, rounding may turn a ray on to the meridian behind or beyond, where it would see what
// the other border shows.
WFV_FN vec3 wfvOnItsSide(vec3 d, float x)
{
  float side = x < 0.0 ? -1.0 : 1.0;
  return vec3(d.z > 0.0 ? side * max(WFV_BESIDE_SEAM, side * d.x) : d.x, d.y, d.z);
}

// The direction of twice the longitude of d, a unit vector (to the right, up, ahead) of the
// half sphere ahead, at the same latitude; on the side of d, however near the meridian behind.
WFV_FN vec3 wfvDoubleLongitude(vec3 d)
{
  float c = wfvHypot(d.x, d.z);
  vec3 r = vec3(0.0, d.y < 0.0 ? -1.0 : 1.0, 0.0);
  if (c > 0.0)
  {
    r = vec3(2.0 * d.x * d.z / c, d.y, (d.x * d.x - d.z * d.z) / c);
  }
  return wfvOnItsSide(r, d.x);
}
