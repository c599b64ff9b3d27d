// SPDX-License-Identifier: BSD-3-Clause
// Fragment side of spheres, cylinders and tubes of an eye whose rays begin in several places.

// Each ray begins at a place of its own, and sees the impostor from there.
vec4 wfvSphereSeen = vec4(0.0);
vec4 wfvOtherSeen = vec4(0.0);
vec3 wfvHitDirection = vec3(0.0); // of the ray that is shown, view coordinates
float wfvDistanceSeen = 0.0;
#define WFV_FROM_EYE wfvHitDirection
#define WFV_DISTANCE wfvDistanceSeen

void wfvStandAt(vec3 start)
{
  wfvSphereSeen = vec4(wfvSphere.xyz - start, wfvSphere.w);
  wfvOtherSeen = vec4(wfvOther.xyz - float(WFV_OTHER_IS_PLACE) * start, wfvOther.w);
}
