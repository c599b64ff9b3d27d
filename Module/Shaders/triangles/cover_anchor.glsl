// SPDX-License-Identifier: BSD-3-Clause
// Fragment side of the pre-clip where rays have no one centre, or are curved: the distance at which
// they meet the plane of the triangle.

// The plane times a direction: above 0 for one that goes towards it.
float wfvApproach(vec3 direction)
{
  return dot(direction, wfvPlane);
}

// Distance at which a ray meets the plane, from the anchor on: what is rounded then is a share
// of the way from there, not of the whole distance.
float wfvMeet(vec3 direction, float approach)
{
#if WFV_NON_CENTRAL
  vec3 anchor = wfvAnchor - wfvStart(direction);
#else
  vec3 anchor = wfvAnchor;
#endif
  float along = dot(direction, anchor);
  return along + dot(wfvPlane, anchor - along * direction) / approach;
}
