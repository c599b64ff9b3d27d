// SPDX-License-Identifier: BSD-3-Clause
// The one sample of a slice (behind volume_curve.glsl).

bool wfvSkipsSample()
{
  wfvStraight = g_dataPos;
  return false;
}
