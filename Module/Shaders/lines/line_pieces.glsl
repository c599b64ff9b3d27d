// SPDX-License-Identifier: BSD-3-Clause
// Lines as chords, geometry stage: which piece of a line its chord may stand for.

// Shares of a piece at which it is measured. Their largest distance from the chord, times
// WFV_CURVE_SAFETY, is no less than that of any point, of an arc that bends one way and of one that
// bends back.
const vec2 WFV_MEASURED = vec2(0.3, 0.6);

// Pixels: an image jumps where it goes farther than the first between two places that are measured,
// or begins or ends there, and between the others no farther than the second.
const float WFV_JUMP = 1.0;
const float WFV_BESIDE_JUMP = 0.1;

// Share of a stretch: no piece is shorter that is shown in part.
const float WFV_LEAST_SHOWN = 1e-5;

// Share of a stretch: no piece is shorter.
const float WFV_LEAST_PIECE = 1e-6;

// Share of a stretch: no piece is longer that is left out.
const float WFV_LONGEST_HIDDEN = 0.0625;

// With fewer places left than these the tolerance gives way, so that all of the line is drawn.
const float WFV_FEW_PLACES = 8.0;

// Pixels round the picture in which a line may still be seen.
const float WFV_PICTURE_PAD = 2.0;

// Places that may still be emitted.
int wfvPlacesLeft = WFV_CHORD_VERTICES / (1 + WFV_WIDE_LINES);

// True where the image is in two parts between one of three pairs of neighbours, and the others are
// beside it. w: of the four places.
bool wfvJumps(vec3 far, vec4 w)
{
  bvec4 shown = greaterThan(w, vec4(0.0));
  bool known = (shown.x && shown.y) || (shown.y && shown.z) || (shown.z && shown.w);
  far.x = shown.x != shown.y ? WFV_UNKNOWN : (shown.x ? far.x : 0.0);
  far.y = shown.y != shown.z ? WFV_UNKNOWN : (shown.y ? far.y : 0.0);
  far.z = shown.z != shown.w ? WFV_UNKNOWN : (shown.z ? far.z : 0.0);
  float most = max(far.x, max(far.y, far.z));
  float other = far.x == most ? max(far.y, far.z)
                              : (far.y == most ? max(far.x, far.z) : max(far.x, far.y));
  return known && most > WFV_JUMP && other < WFV_BESIDE_JUMP;
}

const int WFV_PIECE_DRAWN = 0;
const int WFV_PIECE_LEFT_OUT = 1;
const int WFV_PIECE_TOO_LONG = 2;

// What becomes of the piece from a to d; size: its share of the stretch.
int wfvJudgePiece(WfvPlace a, WfvPlace d, float size)
{
  WfvPlace b = wfvBetween(a, d, WFV_MEASURED.x);
  WfvPlace c = wfvBetween(a, d, WFV_MEASURED.y);
  vec4 w = vec4(a.clip.w, b.clip.w, c.clip.w, d.clip.w);
  vec2 pa = wfvPixelOf(a);
  vec2 pb = wfvPixelOf(b);
  vec2 pc = wfvPixelOf(c);
  vec2 pd = wfvPixelOf(d);
  vec2 low = min(min(pa, pb), min(pc, pd));
  vec2 high = max(max(pa, pb), max(pc, pd));
  vec2 border = 0.5 * wfvViewport.zw + 0.5 * wfvLineWidth + WFV_PICTURE_PAD;
  bool none = max(max(w.x, w.y), max(w.z, w.w)) <= 0.0;
  bool all = min(min(w.x, w.y), min(w.z, w.w)) > 0.0;
  float off = max(length(pb - mix(pa, pd, WFV_MEASURED.x)), length(pc - mix(pa, pd, WFV_MEASURED.y)));
  float few = max(1.0, WFV_FEW_PLACES / float(max(1, wfvPlacesLeft)));
  bool near = all && WFV_CURVE_SAFETY * off <= wfvTolerance * few * few;
  bool outside = none || (all && (any(lessThan(high, -border)) || any(greaterThan(low, border))));
  if (outside && (near || size <= WFV_LONGEST_HIDDEN))
  {
    return WFV_PIECE_LEFT_OUT;
  }
  if (near)
  {
    return WFV_PIECE_DRAWN;
  }
  bool jumps = wfvJumps(vec3(length(pb - pa), length(pc - pb), length(pd - pc)), w);
  bool least = size <= (all ? WFV_LEAST_PIECE : WFV_LEAST_SHOWN);
  return jumps || least ? WFV_PIECE_LEFT_OUT : WFV_PIECE_TOO_LONG;
}
