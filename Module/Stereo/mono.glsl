// SPDX-License-Identifier: BSD-3-Clause
// No stereo: both eyes are at the origin of view coordinates. Every model brings these four
// functions. The first two are about the scene, before the projection, the others about the
// picture, behind it; what a model does not change it hands on. Points and directions are in
// tilted view coordinates, scene units; v.eye says which eye is asked for, v.halfEyes how far apart
// the two are, v.stereo what else the model needs to know.

// The direction in which this eye sees a point, and how far along its ray.
WFV_FN WfvRayHit wfvSee(vec3 p, WfvView v)
{
  return wfvRayHitFrom(p, vec3(0.0, 0.0, 0.0));
}

// Where the ray of a direction (unit length) begins.
WFV_FN vec3 wfvEyeAt(vec3 direction, WfvView v)
{
  return vec3(0.0, 0.0, 0.0);
}

// The place in this eye's picture of what the map puts at ndc, with this depth (-1 on the near,
// 1 on the far clip sphere).
WFV_FN vec2 wfvShift(vec2 ndc, float depth, WfvView v)
{
  return ndc;
}

// Its inverse.
WFV_FN vec2 wfvUnshift(vec2 ndc, float depth, WfvView v)
{
  return ndc;
}
