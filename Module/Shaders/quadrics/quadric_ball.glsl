// SPDX-License-Identifier: BSD-3-Clause
// A ball, by the ray of the pixel.

WfvCrossing wfvMeet(vec3 u)
{
  return wfvMeetBall(u, wfvBallSeen.xyz, wfvBallSeen.w);
}
