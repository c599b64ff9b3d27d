// SPDX-License-Identifier: BSD-3-Clause
// Fragment side of the pre-clip: where a ray-tested triangle meets one drawn with chords.
//
// Both must end at the same line. An edge that neighbours draw as a chord therefore ends
// the ray-tested triangle at that chord too, found from the same two corners in the picture.

flat in vec4 wfvCorners01; // corners 0 and 1 in the picture, pixels from the tile's centre
flat in vec2 wfvCorner2;

// How far, in pixels, a rasterizer snaps its vertices: a chord is widened by so much.
const float WFV_SNAP = 1.0 / 128.0;

// Pixels: shorter chords are points.
const float WFV_SHORT = 0.01;

// Times the sampled distance of an edge from its chord, and pixels: farther from either,
// nothing lies between the two.
const float WFV_LENS_SAFETY = 2.0;
const float WFV_LENS_PAD = 0.02;

// This sample, from the tile's centre as the corners are.
vec2 wfvHere()
{
  return gl_FragCoord.xy + wfvSample - wfvViewport.xy - 0.5 * wfvViewport.zw;
}

// What to add to the function e of an edge, whose slope per pixel this is, to have that of
// the chord from a to b; 0 where the chord does not decide.
float wfvToChord(float e, vec2 slope, float slack, vec2 a, vec2 b)
{
  float steep = length(slope);
  vec2 chord = b - a;
  float l = length(chord);
  vec2 at = wfvHere() - a;
  float along = dot(at, chord) / max(l, 1e-6);
  float beside = (chord.x * at.y - chord.y * at.x) / max(l, 1e-6);
  float inside = dot(vec2(-chord.y, chord.x), slope) < 0.0 ? -beside : beside;
  float thickness = WFV_LENS_SAFETY * slack + WFV_LENS_PAD;
  bool decides = slack >= 0.0 && l > WFV_SHORT && along >= -WFV_SNAP &&
    along <= l + WFV_SNAP && abs(beside) <= thickness && abs(e) <= thickness * steep;
  return decides ? (inside + WFV_SNAP) * steep - e : 0.0;
}

// The chord of edge i from corner a to corner b, numbers 0, 1, 2.
float wfvToChordOf(int i, float e, vec2 slope, float slack, vec2 a, vec2 b)
{
#if WFV_CROSSES_SEAM
  if ((wfvMode & WFV_AT_SEAM) != 0 && !wfvEndAtSeam(i, a, b))
  {
    return 0.0;
  }
#endif
  return wfvToChord(e, slope, slack, a, b);
}

// Pixels from each edge within which its chord counts.
vec3 wfvChordErrors()
{
  return step(0.0, wfvSlack) * (WFV_LENS_SAFETY * wfvSlack + WFV_LENS_PAD);
}

// What to add to the edge functions e, whose slopes per pixel are dx and dy, to have those
// of the chords; 0 where no chord decides.
vec3 wfvToChords(vec3 direction, vec3 e, vec3 dx, vec3 dy)
{
  vec2 c0 = vec2(wfvCorners01.x, wfvCorners01.y);
  vec2 c1 = vec2(wfvCorners01.z, wfvCorners01.w);
  vec2 c2 = wfvCorner2;
  vec4 chord0 = vec4(c1, c2);
  vec4 chord1 = vec4(c2, c0);
  vec4 chord2 = vec4(c0, c1);
  return vec3(wfvToChordOf(0, e.x, vec2(dx.x, dy.x), wfvSlack.x, chord0.xy, chord0.zw),
    wfvToChordOf(1, e.y, vec2(dx.y, dy.y), wfvSlack.y, chord1.xy, chord1.zw),
    wfvToChordOf(2, e.z, vec2(dx.z, dy.z), wfvSlack.z, chord2.xy, chord2.zw));
}

// Inside the three edges, or not, turned round in every lens between an edge and its chord
// that holds the sample. So each sample is in an odd number of the triangles round it,
// even where a thin triangle has no three chords round it.
bool wfvAllInside(vec3 e, vec3 toChords)
{
  bvec3 edge =
    bvec3(wfvInside(e.x, wfvEdge0), wfvInside(e.y, wfvEdge1), wfvInside(e.z, wfvEdge2));
  vec3 c = e + toChords;
  bool turned = (wfvInside(c.x, wfvEdge0) != edge.x) ^^ (wfvInside(c.y, wfvEdge1) != edge.y) ^^
    (wfvInside(c.z, wfvEdge2) != edge.z);
  return all(edge) ^^ turned;
}
