// SPDX-License-Identifier: BSD-3-Clause
// Fragment side of the pre-clip: what the stock shader asks of the surface.

// Of the triangle's own plane, towards the eye, view coordinates. Differences between
// pixels, which stock VTK and the data pass take, are no numbers where a pixel of the quad
// lies outside the map.
#define WFV_FLAT_NORMAL
vec3 wfvFlatNormal()
{
  vec3 n = wfvUntilt(-wfvFacing * wfvPlane, wfvView);
  return n / wfvLength(n);
}

#if WFV_EXACT
// The point itself and the direction from the eye to it, view coordinates.
vec3 wfvSurface = vec3(0.0);
vec3 wfvHitDirection = vec3(0.0);
#define WFV_FROM_EYE wfvHitDirection

void wfvSetSurface(vec3 direction)
{
  wfvHitDirection = wfvUntilt(direction, wfvView);
  wfvSurface = wfvHitDirection * (wfvRho * wfvScale());
#if WFV_NON_CENTRAL
  wfvSurface += wfvUntilt(wfvEyeAt(direction, wfvView), wfvView);
#endif
}
#endif

// Window depth, two steps of a buffer of 24 bits, for each face may be rounded by one: by so much is
// what is seen from behind put back. Where a surface folds away from the eye a pixel's ray may lie so
// near the fold that its front and its back come out at one depth; then the front shows, in whichever
// order they come.
const float WFV_BEHIND = 2.0 / 16777216.0;

// For the data pass.
#define WFV_DISTANCE (wfvRho * wfvScale())
