// SPDX-License-Identifier: BSD-3-Clause
// Depth of what the pre-clip does not cover (points, lines, props without a geometry
// stage), where the mapping is not what the rasterizer interpolates.
float wfvDepth = 0.0; // window depth here, 0 to 1
float wfvRho = 0.0; // distance from the eye here, in the stage's own units

// Of the distance: by so much at the most a face seen from behind is put back, more than the rasterizer errs
// when it interpolates places. Beside an outline a front and a back may meet in one pixel at one
// depth; the front shows.
const float WFV_BACK_YIELDS = 2e-5;

// Of the distance, by which it is moved, the front towards the eye and the back away.
vec2 wfvMoves = vec2(0.0, WFV_BACK_YIELDS);

#if WFV_RAY_DEPTH
// For the data pass.
#define WFV_DISTANCE (wfvRho * wfvScale())

// Sine of the angle between the ray and the plane, from which on the places of neighbouring pixels,
// rounded as they are, say where the plane is.
const float WFV_LEAST_SINE = 0.01;

// Of the distance: how far an interpolated place is off its plane, and over the sine how far off the
// ray then meets it.
const float WFV_OFF_PLANE = 3e-7;

// Distance at which the pixel's own ray meets the plane of the places round about. That is not how
// far the interpolated place is, which is off by as much as a chord from its edge.
float wfvAlongRay(vec3 place, float rho)
{
  vec3 n = cross(dFdx(place), dFdy(place));
  WfvRay ray = wfvRayAt(vec2(0.0));
  vec3 d = wfvUntilt(ray.direction, wfvView);
  float along = dot(n, d);
  float size = wfvTaxiLength(n);
  bool known = ray.inside && abs(along) > WFV_LEAST_SINE * size;
  wfvMoves = known ? vec2(min(WFV_OFF_PLANE * size / abs(along), WFV_BACK_YIELDS)) : wfvMoves;
  return known ? rho + dot(n, place - rho * d) / along : rho;
}
#endif

// place: the fragment's, view coordinates; between the clip spheres, in whose units no square of it
// is too large or too small
void wfvPrepareDepth(vec3 place)
{
  place *= 1.0 / wfvScale();
  wfvRho = length(place);
#if WFV_RAY_DEPTH
  wfvRho = wfvAlongRay(place, wfvRho);
#endif
  wfvDepth = wfvDepthInUnits(wfvRho * (gl_FrontFacing ? 1.0 - wfvMoves.x : 1.0 + wfvMoves.y));
}
