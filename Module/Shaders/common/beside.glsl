// SPDX-License-Identifier: BSD-3-Clause
// Projects the vertices of triangles. A piece of a triangle that ends at a discontinuity of the map
// says on which side of it the vertex is: rounding must not take the vertex to the other side.

// Meridian maps: -1 or 1, the sign of x behind the eye; -2 or 2: the vertex is moved outwards, across
// a curved seam. Round maps: 2, the same across the rim. Maps of faces: 1 to 6, a face of the cube, in
// the order of wfvFaceOf. 0: the vertex is away from every discontinuity.
in float wfvAside;

// Of the distance: so far beside a discontinuity a vertex is put.
const float WFV_ASIDE = 1e-6;

vec3 wfvBeside(vec3 p, float rho)
{
#if WFV_MERIDIAN
  float side = clamp(wfvAside, -1.0, 1.0);
  float x = side * max(side * p.x, WFV_ASIDE * rho);
  return wfvAside != 0.0 ? vec3(x, p.y, p.z) : p;
#elif WFV_FACES
  int axis = (int(wfvAside) - 1) / 2;
  float most = (1.0 - WFV_ASIDE) * abs(axis == 0 ? p.x : axis == 1 ? p.y : p.z);
  vec3 inside = clamp(p, vec3(-most), vec3(most));
  inside = vec3(axis == 0 ? p.x : inside.x, axis == 1 ? p.y : inside.y, axis == 2 ? p.z : inside.z);
  return wfvAside != 0.0 ? inside : p;
#else
  return p;
#endif
}

#if WFV_ROUND || (WFV_MERIDIAN && !WFV_STRAIGHT_SEAM)
// Maps with a curved border: chords of the border lie inside of it, so a skirt reaches from them
// across the border, where the fragment stage ends it. The factor moves its outer vertices.
uniform float wfvSkirt;

vec2 wfvAcrossBorder(vec2 ndc)
{
  return abs(wfvAside) > 1.5 ? ndc * wfvSkirt : ndc;
}
#else
vec2 wfvAcrossBorder(vec2 ndc)
{
  return ndc;
}
#endif

// Clip coordinates. Where the fragment stage writes the depth, triangles are clipped as in a
// perspective: the third coordinate is linear in the distance, so the rasterizer ends an edge where the
// interpolated distance is that of a clip sphere.
vec4 wfvClipBeside(vec2 ndc, float rho)
{
  vec4 at = wfvClip(ndc, rho);
#if WFV_WRITES_DEPTH
  float near = wfvView.radii.x;
  float far = wfvView.radii.y;
  at.z = (rho * (far + near) - 2.0 * far * near) / (far - near);
  // rounding clips nothing between the spheres
  at.z = rho >= near && rho <= far ? clamp(at.z, -rho, rho) : at.z;
#endif
  return at;
}

// View coordinates, as the stock vertex stage leaves them, to clip coordinates.
vec4 wfvProjectBeside(vec3 p)
{
  vec3 q = wfvTilt(p, wfvView);
  float rho = wfvLength(q);
  vec2 ndc = wfvAcrossBorder(wfvProject(wfvBeside(q, rho), wfvView));
  // the eye itself has no place in the map: in front of the near sphere, clipped
  return rho > 0.0 ? wfvClipBeside(ndc, rho) : vec4(0.0, 0.0, -2.0, 1.0);
}
