// SPDX-License-Identifier: BSD-3-Clause
// Fragment side of the pre-clip: where a covered triangle meets one drawn with a chord.
//
// Both must end at the same line. An edge that neighbours draw as a chord therefore ends
// the covered triangle at that chord too, found from the same two corners in the picture.

#if !WFV_EXACT
flat in vec4 wfvCorners01; // corners 0 and 1 in the picture, pixels from the tile's centre
flat in vec2 wfvCorner2;   // corner 2; at WFV_NOWHERE where an edge crosses the seam
#endif

// Added to the slack of a chord: how far, in pixels, a rasterizer snaps its vertices.
const float WFV_SNAP = 1.0 / 128.0;

// Pixels: shorter chords are points.
const float WFV_SHORT = 0.01;

// Pixels beyond the slack within which the chord decides, not the edge itself.
const float WFV_CHORD_REACH = 1.0;

// What to add to the function e of an edge (its slope is per pixel) so that it vanishes on
// the chord from a to b.
float wfvToChord(float e, vec2 slope, float slack, vec2 a, vec2 b)
{
  float steep = length(slope);
  vec2 chord = b - a;
  float l = length(chord);
  vec2 at = gl_FragCoord.xy - wfvViewport.xy - 0.5 * wfvViewport.zw - a;
  float along = dot(at, chord) / max(l * l, 1e-12);
  float beside = (chord.x * at.y - chord.y * at.x) / max(l, 1e-6);
  float inside = dot(vec2(-chord.y, chord.x), slope) < 0.0 ? -beside : beside;
  bool decides = slack >= 0.0 && l > WFV_SHORT && along >= 0.0 && along <= 1.0 &&
    abs(e) <= (2.0 * slack + WFV_CHORD_REACH) * steep;
  return decides ? (inside + WFV_SNAP) * steep - e : 0.0;
}

// Along an edge that crosses the seam: widened by the sampled distance of the chord, most
// in the middle.
vec3 wfvParabola(vec3 e)
{
  vec3 b = max(e, vec3(0.0));
  vec3 j = vec3(b.y, b.z, b.x);
  vec3 k = vec3(b.z, b.x, b.y);
  return 4.0 * j * k / max((j + k) * (j + k), vec3(1e-30));
}

// What to add to the edge functions e, whose slopes per pixel are dx and dy.
vec3 wfvWidening(vec3 e, vec3 dx, vec3 dy)
{
#if WFV_EXACT
  return vec3(0.0);
#else
  vec3 perPixel = (abs(dx) + abs(dy)) * step(0.0, wfvSlack);
  bool seam = wfvCorner2.x >= WFV_NOWHERE;
  return seam ? (wfvSlack * wfvParabola(e) + WFV_SNAP) * perPixel : vec3(0.0);
#endif
}

// What to add to an edge function to have that of its chord; 0 where no chord decides.
vec3 wfvToChords(vec3 e, vec3 dx, vec3 dy)
{
#if WFV_EXACT
  return vec3(0.0);
#else
  vec2 c0 = vec2(wfvCorners01.x, wfvCorners01.y);
  vec2 c1 = vec2(wfvCorners01.z, wfvCorners01.w);
  return vec3(wfvToChord(e.x, vec2(dx.x, dy.x), wfvSlack.x, c1, wfvCorner2),
    wfvToChord(e.y, vec2(dx.y, dy.y), wfvSlack.y, wfvCorner2, c0),
    wfvToChord(e.z, vec2(dx.z, dy.z), wfvSlack.z, c0, c1));
#endif
}

bool wfvInside(float e, int tie)
{
  return e > 0.0 || (e == 0.0 && tie != 0);
}

// Inside the three edges, or not, turned round in every lens between an edge and its chord
// that holds the sample. So each sample is in an odd number of the triangles round it,
// even where a thin triangle has no three chords round it.
bool wfvAllInside(vec3 e, vec3 toChords)
{
  bvec3 edge = bvec3(wfvInside(e.x, wfvMode & 2), wfvInside(e.y, wfvMode & 4),
    wfvInside(e.z, wfvMode & 8));
  vec3 c = e + toChords;
  bool turned = (wfvInside(c.x, wfvMode & 2) != edge.x) ^^ (wfvInside(c.y, wfvMode & 4) != edge.y) ^^
    (wfvInside(c.z, wfvMode & 8) != edge.z);
  return all(edge) ^^ turned;
}
