// SPDX-License-Identifier: BSD-3-Clause
// Tessellation: how finely each edge of a triangle is cut, and where.
//
// An edge is measured in WFV_INTERVALS intervals, from its lexicographically first end to
// its second, so that both triangles at an edge find the same numbers: how far, in pixels,
// the picture of the middle of an interval lies from its chord. An interval counts with the
// square root of its error, and the pieces are shared out by that count: short ones where an
// edge passes a pole or the antipode, long ones where the map is nearly flat.

// The program says before this that there are three corners: layout(vertices = 3) out.
// Of the edge opposite to each corner; see wfvMeasure. Outputs of a corner, not an array of the patch:
// of that, written by constant indices, Mesa 25.0 takes all elements for copies of the first edge's.
out vec4 wfvFirstSteps[];
out vec4 wfvLastSteps[];
out float wfvMost[]; // pieces that an edge, or the line beside it, asks for

uniform float wfvMaxLevel; // WFV_MOST_PIECES or less

// Share of the tolerance that a piece may use up: the pre-clip measures it again, with
// its own safety, and covers by rays what exceeds the tolerance.
const float WFV_PIECE_SHARE = 0.6;

// How much of a shift along the chord counts.
const float WFV_ALONG = 0.2;

// Most pieces that one interval may ask for: past that its pieces go exact.
const float WFV_INTERVAL_PIECES = 16.0;

// Most pieces of an interval next to a pole or the antipode, whose pieces the pre-clip
// covers anyway.
const float WFV_SINGULAR_PIECES = 3.0;

// Every interval counts at least this share of the mean, which keeps the places apart.
const float WFV_LEAST_SHARE = 0.05;

// NDC beyond the picture by which an interval counts as outside.
const float WFV_SEEN = 1.1;

float wfvAzimuth = 0.0; // of the point before, for continuing across the seam

// Place in the picture, pixels from its centre; longitudes go on across the seam.
vec2 wfvPlace(vec3 p)
{
  vec2 half_ = 0.5 * wfvViewport.zw * wfvTile.xy;
#if WFV_MERIDIAN
  vec2 angles = wfvMeridianAngles(p);
  wfvAzimuth = wfvAzimuth + wfvWrap(angles.x - wfvAzimuth);
  return half_ * wfvMap(vec2(wfvAzimuth, angles.y), wfvView);
#else
  return half_ * wfvProject(p, wfvView);
#endif
}

// Pieces that the chord from a to b asks for; m is the picture of the middle. Across the
// chord its whole distance counts. What is seen there is found by the ray of the pixel, but
// for the narrow lens between an edge and its chord; there a shift along the chord shows a
// wrong depth and wrong attributes, so it counts for a part.
float wfvPieces(vec2 a, vec2 m, vec2 b)
{
  vec2 error = m - 0.5 * (a + b);
  vec2 chord = b - a;
  float l = length(chord);
  float across = abs(chord.x * error.y - chord.y * error.x) / max(l, 1e-6);
  float pixels = max(l > 0.01 ? across : 0.0, WFV_ALONG * length(error));
  return sqrt(pixels / (WFV_PIECE_SHARE * wfvTolerance));
}

bool wfvIsOutside(vec2 a, vec2 b)
{
  vec2 rim = WFV_SEEN * 0.5 * wfvViewport.zw * wfvTile.xy;
  return min(a.x, b.x) > rim.x || max(a.x, b.x) < -rim.x || min(a.y, b.y) > rim.y ||
    max(a.y, b.y) < -rim.y;
}

// How many pieces the interval from a to b (unit vectors; la and lb from the eye) asks for;
// at and to are the pictures of its ends.
float wfvCount(vec3 a, vec3 b, vec2 at, vec2 middle, vec2 to)
{
  if (wfvIsOutside(at, to))
  {
    return 0.0;
  }
  float pieces = wfvPieces(at, middle, to);
  float most = wfvNearsSingularity(a, b) ? WFV_SINGULAR_PIECES : WFV_INTERVAL_PIECES;
  return pieces >= 0.0 ? min(pieces, most) : most; // not a number: as many as may be
}

// The pieces that the edge asks for. steps[k] is the share of them before the end of
// interval k.
float wfvMeasure(vec3 p, vec3 q, out float steps[WFV_INTERVALS])
{
  bool ordered = wfvOrdered(p, q);
  vec3 a = ordered ? p : q;
  vec3 b = ordered ? q : p;
  float la = max(wfvLength(a), 1e-30);
  float lb = max(wfvLength(b), 1e-30);
  a = a / la;
  b = b / lb;
  float counts[WFV_INTERVALS];
  float sum = 0.0;
  wfvAzimuth = 0.0;
  vec3 here = a;
  vec2 at = wfvPlace(a);
  for (int k = 0; k < WFV_INTERVALS; k++)
  {
    float middle = (float(k) + 0.5) / float(WFV_INTERVALS);
    float end = float(k + 1) / float(WFV_INTERVALS);
    vec2 m = wfvPlace(mix(a, b, middle));
    vec3 next = mix(a, b, end);
    vec2 to = wfvPlace(next);
    counts[k] = wfvCount(normalize(here), normalize(next), at, m, to);
    sum += counts[k];
    here = next;
    at = to;
  }
  float least = WFV_LEAST_SHARE * sum / float(WFV_INTERVALS) + 1e-6;
  float total = sum + least * float(WFV_INTERVALS);
  float before = 0.0;
  for (int k = 0; k < WFV_INTERVALS; k++)
  {
    before += counts[k] + least;
    steps[k] = before / total;
  }
  return sum;
}

float wfvLevel(float pieces)
{
  return clamp(ceil(pieces), 1.0, wfvMaxLevel);
}

// One edge's answer, by constant indices: where each invocation writes an element of its
// own, llvmpipe 22.3 writes them all to one.
void wfvAnswer(float level)
{
  if (gl_InvocationID == 0)
  {
    gl_TessLevelOuter[0] = level;
  }
  else if (gl_InvocationID == 1)
  {
    gl_TessLevelOuter[1] = level;
  }
  else
  {
    gl_TessLevelOuter[2] = level;
  }
}

void main()
{
  gl_out[gl_InvocationID].gl_Position = gl_in[gl_InvocationID].gl_Position;
  wfvPass();
  vec3 p[3];
  for (int i = 0; i < 3; i++)
  {
    int from = (gl_InvocationID + i) % 3;
    p[i] = wfvTilt(gl_in[from].gl_Position.xyz, wfvView) / wfvScale();
  }
  float steps[WFV_INTERVALS];
  float pieces = wfvMeasure(p[1], p[2], steps);
  wfvAnswer(wfvLevel(pieces));
  wfvFirstSteps[gl_InvocationID] = vec4(steps[0], steps[1], steps[2], steps[3]);
  wfvLastSteps[gl_InvocationID] = vec4(steps[4], steps[5], steps[6], steps[7]);
  // the line halfway between this edge and the corner opposite to it
  vec3 corner = normalize(p[0]);
  float middle = 2.0 * wfvMeasure(normalize(p[1]) + corner, normalize(p[2]) + corner, steps);
  wfvMost[gl_InvocationID] = max(pieces, middle);
  barrier();
  if (gl_InvocationID == 0)
  {
    gl_TessLevelInner[0] = wfvLevel(max(wfvMost[0], max(wfvMost[1], wfvMost[2])));
  }
}
