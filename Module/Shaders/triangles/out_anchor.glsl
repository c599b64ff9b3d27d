// SPDX-License-Identifier: BSD-3-Clause
// Pre-clip of triangles: a point of its plane, where rays have no one centre or are curved.

flat out vec3 wfvAnchor;
vec3 wfvA = vec3(0.0);

void wfvWriteAnchor()
{
  wfvAnchor = wfvA;
}

bool wfvIsLong(vec3 lengths); // preclip_planes.glsl

// A point of the plane, for the fragment stage: the nearest corner; of a long triangle the foot
// of the perpendicular from the eye.
vec3 wfvAnchorOf(vec4 plane, vec3 lengths)
{
  if (wfvIsLong(lengths))
  {
    // in parts: squares of a small one's products are below the least float
    float largest = max(abs(plane.x), max(abs(plane.y), abs(plane.z)));
    vec3 n = plane.xyz / largest;
    return n * (plane.w / largest / dot(n, n));
  }
  float nearest = min(lengths.x, min(lengths.y, lengths.z));
  return lengths.x == nearest ? wfvP[0] : (lengths.y == nearest ? wfvP[1] : wfvP[2]);
}
