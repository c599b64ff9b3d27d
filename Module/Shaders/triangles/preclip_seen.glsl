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

// Seen edge-on, or not a number: it covers no pixel.
bool wfvIsNothing()
{
#if WFV_NON_CENTRAL
  return wfvNcNothing();
#else
  return !(abs(wfvT.w) > 0.0);
#endif
}
