// SPDX-License-Identifier: BSD-3-Clause
// Fragment side of the pre-clip where each ray of an eye begins at a place of its own: how a ray sees
// the triangle from there.

flat in vec3 wfvSpan0;
flat in vec3 wfvSpan1;
flat in vec3 wfvSpan2;
float wfvTurn = 0.0; // of the ray asked for last: -1 where it sees the other side than the origin
float wfvFacing = 1.0; // that of the pixel's centre

// Where the ray of a direction begins, the stage's own units.
vec3 wfvStart(vec3 direction)
{
  return wfvEyeAt(direction, wfvView) * (1.0 / wfvScale()); // a power of two
}

// Times the triangle's normal, how far its plane is ahead of such a place; below 0 for one that
// sees it from the side that the origin does not.
float wfvAhead(vec3 start)
{
  return dot(wfvPlane, wfvAnchor - start);
}

// Share of the angle to the axis of the circle: rays that turn about it by more from pixel to
// pixel say nothing of what is between them.
const float WFV_TURNING = 0.1;

// True where the places at which rays begin turn about within this pixel.
bool wfvTurns(vec3 direction)
{
  vec3 x = dFdx(direction);
  vec3 y = dFdy(direction);
  float axis = wfvLength(cross(direction, wfvUpright(wfvView)));
  return !(length(x) + length(y) < WFV_TURNING * axis);
}
