// SPDX-License-Identifier: BSD-3-Clause
// Pre-clip of triangles: what is drawn of it where it is not ray-tested.

out vec3 wfvBary;        // barycentric coordinates
out vec3 wfvPosition;    // the surface
flat out vec3 wfvSlack;  // pixels by which edge i is widened to meet its chord; < 0: none

void wfvWriteSlack()
{
  wfvSlack = wfvS;
}
