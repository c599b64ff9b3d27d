// SPDX-License-Identifier: BSD-3-Clause
// Off-axis stereo of a perspective: two eyes side by side whose frusta share the plane of
// convergence, x_clip += eye separation (w - convergence). Parallax, as a fraction of the
// picture's width: separation (1 - convergence / w); nothing at the convergence, the separation
// far away, - separation at half the convergence. Source: S. Gateau and S. Nash, Implementing
// Stereoscopic 3D in Your Applications.
//
// v.halfEyes: scene units
// v.stereo:   x  by how much the pictures are shifted, NDC

WFV_FN float wfvShiftOfPicture(WfvView v)
{
  return v.eye == WFV_EYE_LEFT ? -v.stereo.x : v.eye == WFV_EYE_RIGHT ? v.stereo.x : 0.0;
}

WFV_FN WfvRayHit wfvSee(vec3 p, WfvView v)
{
  return wfvRayHitFrom(p, vec3(wfvToRight(v), 0.0, 0.0));
}

WFV_FN vec3 wfvEyeAt(vec3 direction, WfvView v)
{
  return vec3(wfvToRight(v), 0.0, 0.0);
}

WFV_FN vec2 wfvShift(vec2 ndc, float depth, WfvView v)
{
  return vec2(ndc.x + wfvShiftOfPicture(v), ndc.y);
}

WFV_FN vec2 wfvUnshift(vec2 ndc, float depth, WfvView v)
{
  return vec2(ndc.x - wfvShiftOfPicture(v), ndc.y);
}
