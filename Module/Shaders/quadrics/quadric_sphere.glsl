// SPDX-License-Identifier: BSD-3-Clause
// A sphere, by the ray of the pixel.

WfvCrossing wfvMeet(vec3 u)
{
  return wfvMeetSphere(u, wfvSphereSeen.xyz, wfvSphereSeen.w);
}
