// SPDX-License-Identifier: BSD-3-Clause
// Pre-clip: how far an edge is from its chord in the map (behind edge_singular.glsl).

// Map of p, continued across the seam from the longitude of the point before it.
#if WFV_MERIDIAN && WFV_STRAIGHT_SEAM
vec2 wfvContinued(vec3 p, vec2 from)
{
  vec2 a = wfvMeridianAngles(p);
  return vec2(from.x + wfvWrap(a.x - from.x), a.y);
}
#endif

// Largest distance, in pixels, between the chord of a and b in the map and the places of an edge
// between them, in this order: p, m, q; WFV_UNKNOWN where these say little of what is between.
float wfvSampledError(vec3 a, vec3 p, vec3 m, vec3 q, vec3 b)
{
#if WFV_MERIDIAN && WFV_STRAIGHT_SEAM
  // longitudes are continued along the edge: the seam does not count as curvature
  vec2 ta = wfvMeridianAngles(a);
  vec2 tp = wfvContinued(p, ta);
  vec2 tm = wfvContinued(m, tp);
  vec2 tq = wfvContinued(q, tm);
  vec2 tb = wfvContinued(b, tq);
  vec2 na = wfvMap(ta, wfvView);
  vec2 np = wfvMap(tp, wfvView);
  vec2 nm = wfvMap(tm, wfvView);
  vec2 nq = wfvMap(tq, wfvView);
  vec2 nb = wfvMap(tb, wfvView);
#else
  vec2 na = wfvProject(a, wfvView);
  vec2 np = wfvProject(p, wfvView);
  vec2 nm = wfvProject(m, wfvView);
  vec2 nq = wfvProject(q, wfvView);
  vec2 nb = wfvProject(b, wfvView);
#endif
  float middle = wfvChordDistance(na, nb, nm);
  float quarters = max(wfvChordDistance(na, nb, np), wfvChordDistance(na, nb, nq));
  float e = max(middle, quarters);
  bool even = quarters <= WFV_EVEN_CURVATURE * middle &&
    min(wfvChordShare(na, nb, np), 1.0 - wfvChordShare(na, nb, nq)) >= WFV_EVEN_SHARE;
  return e > WFV_NEAR_CHORD && !even ? WFV_UNKNOWN : WFV_CURVE_SAFETY * e;
}

// The same of a great circle's arc.
float wfvEdgeError(vec3 a, vec3 b)
{
  vec3 m = normalize(a + b);
  return wfvSampledError(a, normalize(a + m), m, normalize(m + b), b);
}

// The chord p, q in the map against its edge. x: by how many pixels they differ, or
// WFV_CURVED where that is more than the tolerance. y: a bound of the pixels,
// WFV_UNKNOWN near places where the map has none.
vec2 wfvChordError(vec3 p, vec3 q)
{
  vec3 a = wfvOrdered(p, q) ? p : q;
  vec3 b = wfvOrdered(p, q) ? q : p;
  vec3 da = normalize(a);
  vec3 db = normalize(b);
  float c = dot(da, db);
  bool unknown = !(c > -0.5) || wfvNearsSingularity(da, db);
#if WFV_MERIDIAN && !WFV_STRAIGHT_SEAM
  unknown = unknown ||
    (min(a.x, b.x) <= 0.0 && max(a.x, b.x) >= 0.0 && (a.z > 0.0 || b.z > 0.0));
#endif
#if WFV_FACES
  unknown = unknown || wfvFaceOf(da) != wfvFaceOf(db);
#elif WFV_ROUND
  unknown = unknown || -max(da.z, db.z) < wfvChordEnd();
#endif
  if (unknown)
  {
    return vec2(WFV_CURVED, WFV_UNKNOWN);
  }
  float error = wfvEdgeError(da, db);
  return vec2(error <= wfvTolerance ? error : WFV_CURVED, c > 0.5 ? error : WFV_UNKNOWN);
}
