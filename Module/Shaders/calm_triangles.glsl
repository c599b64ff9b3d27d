// SPDX-License-Identifier: BSD-3-Clause
// Covers triangles of which is known (vtkWideFoVSorter.h) that they are small, that nothing is torn
// where they are, and how near their edges stay to their chords: most of those of a fine mesh.
// preclip_triangles.glsl finds that out for each, and has an answer for all; software rendering
// runs through all these answers every time.

// Pixels by which an edge of one radian might be off its chord, and by which none is.
uniform vec2 wfvCalm;

void main()
{
  wfvReadCorners();
  vec3 lengths = vec3(length(wfvP[0]), length(wfvP[1]), length(wfvP[2]));
  wfvT = wfvTrianglePlane(lengths);
  // seen edge-on, or not a number: it covers no pixel
#if WFV_OWN_RAYS
  bool none = wfvOwnNothing();
#else
  bool none = !(abs(wfvT.w) > 0.0);
#endif
  if (none)
  {
    return;
  }
  wfvFacePlanes(lengths);
#if WFV_OWN_RAYS
  wfvSetSpans(wfvT.w > 0.0 ? 1.0 : -1.0);
#endif
  wfvVertexMode = WFV_COVERED;
  vec3 edges = vec3(dot(wfvP[1] - wfvP[2], wfvP[1] - wfvP[2]) / (lengths.y * lengths.z),
    dot(wfvP[2] - wfvP[0], wfvP[2] - wfvP[0]) / (lengths.z * lengths.x),
    dot(wfvP[0] - wfvP[1], wfvP[0] - wfvP[1]) / (lengths.x * lengths.y));
  float reach = min(wfvCalm.x * max(edges.x, max(edges.y, edges.z)), wfvCalm.y);
  wfvCoverTight(reach + WFV_TIGHT_PAD, wfvT.w < 0.0);
}
