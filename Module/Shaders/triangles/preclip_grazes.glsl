// SPDX-License-Identifier: BSD-3-Clause
// Pre-clip of triangles of rays from one centre: those that all but pass through it.

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
