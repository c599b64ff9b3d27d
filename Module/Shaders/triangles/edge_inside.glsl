// SPDX-License-Identifier: BSD-3-Clause
// Fragment side of the pre-clip: on which side of an edge a ray is.

// A ray that lies in the plane of an edge is decided as if it were shifted by a hair along
// x, by less along y and by less again along z: the same shift for every edge, so what is
// shown there is what the shifted ray sees, and neighbours still decide apart.
bool wfvInside(float e, WFV_EDGE n)
{
  WFV_SIDE shifted = n.x != 0.0 ? n.x : (n.y != 0.0 ? n.y : n.z);
#if WFV_NON_CENTRAL
  shifted *= wfvTurn;
#endif
  return e > 0.0 || (e == 0.0 && shifted > 0.0);
}
