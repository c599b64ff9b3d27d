// SPDX-License-Identifier: BSD-3-Clause
// Projects the vertices of triangles. A piece of a triangle that ends at a discontinuity of the map
// says on which side of it the vertex is: rounding must not take the vertex to the other side.

// Meridian maps: -1 or 1, the sign of x behind the eye. Maps of faces: 1 to 6, a face of the cube,
// in the order of wfvFaceOf. 0: the vertex is away from every discontinuity.
in float wfvAside;

// Of the distance: so far beside a discontinuity a vertex is put.
const float WFV_ASIDE = 1e-6;

vec3 wfvBeside(vec3 p, float rho)
{
#if WFV_MERIDIAN
  float x = wfvAside * max(wfvAside * p.x, WFV_ASIDE * rho);
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

#if WFV_ROUND
// Round maps that show the antipode: the sine of the angle from it within which vertices are moved
// outwards, and the factor. Triangles that hold the antipode are left out, and chords of the rim
// lie inside of it: moved by half of the tolerance, the others reach the rim.
uniform vec2 wfvRim;

vec2 wfvAtRim(vec2 ndc, vec3 p, float rho)
{
  bool near_ = p.z > 0.0 && length(p.xy) < wfvRim.x * rho;
  return near_ ? ndc * wfvRim.y : ndc;
}
#else
vec2 wfvAtRim(vec2 ndc, vec3 p, float rho)
{
  return ndc;
}
#endif

// View coordinates, as the stock vertex stage leaves them, to clip coordinates.
vec4 wfvProjectBeside(vec3 p)
{
  vec3 q = wfvTilt(p, wfvView);
  float rho = wfvLength(q);
  vec2 ndc = wfvAtRim(wfvProject(wfvBeside(q, rho), wfvView), q, rho);
  // the eye itself has no place in the map: in front of the near sphere, clipped
  return rho > 0.0 ? wfvClip(ndc, rho) : vec4(0.0, 0.0, -2.0, 1.0);
}
