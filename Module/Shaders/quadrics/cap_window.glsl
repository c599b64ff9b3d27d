// SPDX-License-Identifier: BSD-3-Clause
// Covers a cap in maps that say nothing of angles: the whole window is sure.

void wfvCoverCap(vec3 centre, float angle, bool front)
{
  wfvEmitWindow(front);
}
