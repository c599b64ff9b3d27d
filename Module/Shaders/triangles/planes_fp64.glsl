// SPDX-License-Identifier: BSD-3-Clause
// Pre-clip of triangles: the planes through the eye and each edge, and the triangle's own.
//
// View coordinates of a corner are rounded by its own distance from the eye. Seen at that
// distance the angle is nothing, but not where an edge or the triangle passes the eye much
// nearer than its corners are; nor does float32 tell from which side a triangle is seen that
// is nearly edge-on, or on which side of a ray, that a vertex all but meets, its edges pass. So
// where OpenGL has doubles the planes are computed in them, from the coordinates of the vertex
// buffer, and rounded last.

#if WFV_MODEL
in vec3 wfvModel[]; // eye_vertex.glsl
uniform dmat3 wfvToView; // not rounded, as a float32 matrix is
uniform int wfvEyeKnown;
uniform vec3 wfvEyeHigh;
uniform vec3 wfvEyeLow;
#endif

// Share of the product of the corners' distances below which a determinant is rounding:
// the eye has 48 bits here, there are three corners, and some room.
const double WFV_EDGE_ON = 1e-14lf;

// Corner i in the stage's own units, not tilted: planes are tilted once they are known.
dvec3 wfvFp64(int i)
{
  dvec3 p = dvec3(gl_in[i].gl_Position.xyz);
#if WFV_MODEL
  dvec3 relative = (dvec3(wfvModel[i]) - dvec3(wfvEyeHigh)) - dvec3(wfvEyeLow);
  p = wfvEyeKnown != 0 ? wfvToView * relative : p;
#endif
  return p / double(wfvScale());
}

// What wfvView.tilt has too few digits for.
uniform vec2 wfvTiltLow;

dvec3 wfvTiltFp64(dvec3 p)
{
  if (!WFV_TILTED)
  {
    return p;
  }
  dvec2 t = dvec2(wfvView.tilt) + dvec2(wfvTiltLow);
  return dvec3(p.x, t.x * p.y + t.y * p.z, t.x * p.z - t.y * p.y);
}

// Plane through the eye and the edge of corners i and j, the same to the last bit from both
// sides.
WFV_EDGE wfvEdgePlane(int i, int j)
{
  bool ordered = wfvOrdered(wfvP[i], wfvP[j]);
  dvec3 p = ordered ? wfvFp64(i) : wfvFp64(j);
  dvec3 q = ordered ? wfvFp64(j) : wfvFp64(i);
  dvec3 n = cross(p, q - p);
#if WFV_FACES
  n += cross(dvec3(wfvEdgeTurn()), n);
#endif
#if WFV_FP64
  dvec3 seen = wfvTiltFp64(n);
#else
  vec3 seen = wfvTilt(vec3(n), wfvView);
#endif
  return ordered ? seen : -seen;
}

// The triangle's own plane; w is 0 where it is seen edge-on. Sets wfvM, and wfvD for rays in float32.
vec4 wfvTrianglePlane(vec3 lengths)
{
  dvec3 p = wfvFp64(0);
  dvec3 q = wfvFp64(1);
  dvec3 r = wfvFp64(2);
  dvec3 normal = cross(q - p, r - p);
  double w = dot(normal, p);
  bool edgeOn = abs(w) <= WFV_EDGE_ON * length(p) * length(q) * length(r);
#if WFV_DOUBLES
  wfvM = w;
#else
  wfvD = wfvTowardOf(lengths);
  wfvM = vec2(float(dot(wfvTiltFp64(normal), dvec3(wfvD))), float(w));
#endif
  return vec4(wfvTilt(vec3(normal), wfvView), edgeOn ? 0.0 : float(w));
}
