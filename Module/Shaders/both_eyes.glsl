// SPDX-License-Identifier: BSD-3-Clause
// A geometry stage that runs once an eye: for the left one, then for the right one, each into the
// layer of its own.

flat out float wfvEye; // wfvSeeBy

// First of all.
void wfvChooseEye()
{
  wfvSeeBy(WFV_RUN == 0 ? wfvEyes.x : wfvEyes.y);
}
