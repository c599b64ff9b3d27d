// SPDX-License-Identifier: BSD-3-Clause
// Pre-clip of triangles: how the rays from one centre meet its plane.

#if WFV_DOUBLES
flat out double wfvOfPoints; // the plane times any of its points
#else
flat out vec3 wfvToward; // a direction near it, or 0
flat out vec2 wfvMeets;  // the plane times that direction, and times any of its points
#endif

void wfvWriteMeets()
{
#if WFV_DOUBLES
  wfvOfPoints = wfvM;
#else
  wfvToward = wfvD;
  wfvMeets = wfvM;
#endif
}
