// SPDX-License-Identifier: BSD-3-Clause
// The paper's stereo: the map with its depth fills the unit cube, and the cube is an object
// that two off-axis perspectives look at, onto the plane of zero parallax. What is at the depth
// `offset` stays where it is; what is nearer grows and is seen to the other side by each eye.
// Source: Ardouin et al. 2014, section 3.5. The rays of this eye are curves: lines of the
// cube, that the map curves.
//
// v.halfEyes: half of iod, NDC
// v.stereo:   x, y  the viewer, between the eyes: NDC to the right of and above the cube's axis
//             z     distance of the viewer in front of the plane of zero parallax, NDC
//             w     that plane, NDC depth

// The eye, NDC from the cube's axis.
WFV_FN vec2 wfvEyeBeforeCube(WfvView v)
{
  return vec2(v.stereo.x + wfvToRight(v), v.stereo.y);
}

WFV_FN WfvRayHit wfvSee(vec3 p, WfvView v)
{
  return wfvRayHitFrom(p, vec3(0.0, 0.0, 0.0));
}

WFV_FN vec3 wfvEyeAt(vec3 direction, WfvView v)
{
  return vec3(0.0, 0.0, 0.0);
}

WFV_FN vec2 wfvShift(vec2 ndc, float depth, WfvView v)
{
  float k = v.stereo.z / (v.stereo.z + (depth - v.stereo.w));
  vec2 eye = wfvEyeBeforeCube(v);
  return eye + (ndc - eye) * k;
}

WFV_FN vec2 wfvUnshift(vec2 ndc, float depth, WfvView v)
{
  float k = (v.stereo.z + (depth - v.stereo.w)) / v.stereo.z;
  vec2 eye = wfvEyeBeforeCube(v);
  return eye + (ndc - eye) * k;
}
