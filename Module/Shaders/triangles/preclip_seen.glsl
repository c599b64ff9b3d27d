// SPDX-License-Identifier: BSD-3-Clause
// Pre-clip of triangles: whether one is seen at all, and whether it meets the seam.

// True where the triangle reaches the plane x = 0 behind the eye, or lies on more than
// one face of the cube.
bool wfvReachesSeam()
{
#if WFV_NON_CENTRAL
  return wfvNcReachesSeam();
#elif WFV_FACES
  int face = wfvFaceOf(wfvP[0]);
  return wfvFaceOf(wfvP[1]) != face || wfvFaceOf(wfvP[2]) != face;
#elif !WFV_MERIDIAN
  return false;
#endif
  for (int i = 0; i < 3; i++)
  {
    vec3 p = wfvP[i];
    vec3 q = wfvP[i == 2 ? 0 : i + 1];
    bool on = p.x == 0.0 && p.z > 0.0;
    bool crosses = (p.x < 0.0 && q.x > 0.0) || (p.x > 0.0 && q.x < 0.0);
    if (on || (crosses && wfvSeamPoint(p, q).z > 0.0))
    {
      return true;
    }
  }
  return false;
}

// Surely nothing to see: all corners inside the near sphere or, for round maps of 180
// degrees and more, inside the cone that the domain leaves out.
bool wfvOutside(vec3 lengths)
{
  if (max(lengths.x, max(lengths.y, lengths.z)) * wfvScale() < wfvView.radii.x)
  {
    return true;
  }
#if WFV_NON_CENTRAL
  return wfvNcUnseen();
#elif !WFV_ROUND
  return false;
#else
  vec3 cosines = -vec3(wfvP[0].z, wfvP[1].z, wfvP[2].z) / lengths;
  float rim = cos(wfvView.maxAngle) - WFV_POLE_SLACK;
  return rim <= 0.0 && max(cosines.x, max(cosines.y, cosines.z)) < rim;
#endif
}

#if !WFV_NON_CENTRAL
// Radians: what float32 rays do not tell from a line.
const float WFV_GRAZING = 1e-6;

// From the eye to the nearest place of the edge p, q.
float wfvEdgeDistance(vec3 p, vec3 q)
{
  vec3 along = q - p;
  float share = clamp(-dot(p, along) / max(dot(along, along), 1e-30), 0.0, 1.0);
  return length(p + share * along);
}

// True of a triangle that reaches into the near sphere, and beyond it is seen as a band no wider
// than WFV_GRAZING: its plane passes the eye that closely. One that stays outside the sphere is drawn
// however thin, for its neighbours leave it the pixels that look at it.
bool wfvGrazes()
{
  // bounds of lengths, whose squares may be too small or too large for a float
  float normal = max(abs(wfvT.x), max(abs(wfvT.y), abs(wfvT.z)));
  float near = wfvView.radii.x / wfvScale();
  vec3 above = vec3(dot(wfvN[0] / normal, wfvT.xyz), dot(wfvN[1] / normal, wfvT.xyz),
    dot(wfvN[2] / normal, wfvT.xyz));
  float edges = min(wfvEdgeDistance(wfvP[1], wfvP[2]),
    min(wfvEdgeDistance(wfvP[2], wfvP[0]), wfvEdgeDistance(wfvP[0], wfvP[1])));
  bool reaches = min(above.x, min(above.y, above.z)) >= 0.0 || edges < near;
  return reaches && abs(wfvT.w) < WFV_GRAZING * near * normal;
}
#endif

// Seen edge-on, or not a number: it covers no pixel.
bool wfvIsNothing()
{
#if WFV_NON_CENTRAL
  return wfvNcNothing();
#else
  return !(abs(wfvT.w) > 0.0);
#endif
}
