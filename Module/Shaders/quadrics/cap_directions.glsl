// SPDX-License-Identifier: BSD-3-Clause
// Covers a cap in direction maps.

void wfvCoverCap(vec3 centre, float angle, bool front)
{
  float l = wfvLength(centre);
  if (l > 0.0)
  {
    WfvPlaces places = wfvCapPlaces(centre / l, angle + WFV_CAP_PAD, wfvView);
    bool both = places.second.x <= places.second.z;
    wfvEmitBox(both ? wfvUnited(places.first, places.second) : places.first, front);
    return;
  }
  wfvEmitWindow(front);
}
