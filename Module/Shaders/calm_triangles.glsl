// SPDX-License-Identifier: BSD-3-Clause
// Covers triangles of which is known (vtkWideFoVSorter.h) that they are small, that nothing is torn
// where they are, and how near their edges stay to their chords: most of those of a fine mesh.
// preclip_triangles.glsl finds that out for each, and has an answer for all; software rendering
// runs through all these answers every time.

// Of every triangle, ten bits for the side opposite to each corner: how far to move it out from its
// chord (TriangleJudge::Verdict).
uniform usamplerBuffer wfvReaches;

// Among them, that of the first triangle that is drawn.
uniform int wfvFirstReach;

// Of these numbers, in a pixel.
const float WFV_REACHES = 64.0;

// In their place where the two uppermost bits are set: the number of a rectangle that covers a part
// of the triangle (TrianglePieces), pixels; its first corner and its side, how high it is, and
// CoverPiece::Eye.
uniform samplerBuffer wfvPieces;
const uint WFV_PIECE = 3u << 30u;

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
  uint reaches = texelFetch(wfvReaches, gl_PrimitiveIDIn + wfvFirstReach).x;
  vec3 grow = vec3(reaches & 1023u, (reaches >> 10u) & 1023u, reaches >> 20u) / WFV_REACHES;
  bool front = wfvT.w < 0.0;
  int corners = wfvTightShape(grow, front);
  if (reaches >= WFV_PIECE)
  {
    int piece = 2 * int(reaches & ~WFV_PIECE);
    vec4 side = texelFetch(wfvPieces, piece);
    vec4 more = texelFetch(wfvPieces, piece + 1);
    wfvRectangle(side.xy, side.zw, more.x * normalize(vec2(-side.w, side.z)), front);
    corners = more.y * wfvView.stereo.x < 0.0 ? 0 : 4;
  }
  wfvEmitShape(corners);
}
