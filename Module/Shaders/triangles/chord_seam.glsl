// SPDX-License-Identifier: BSD-3-Clause
// Fragment side of the pre-clip: chords of triangles that cross a straight seam.

flat in vec4 wfvSeam; // where the edges cross it: three heights, and the seam's x

// wfvMode of a triangle that reaches the seam.
const int WFV_AT_SEAM = 128;

vec2 wfvHere(); // chord_fragment.glsl

// There the chord of edge i from corner a to corner b has two parts, which end where the edge crosses:
// this pixel's side has one of them, if any. Moves a and b to its ends.
bool wfvEndAtSeam(int i, inout vec2 a, inout vec2 b)
{
  vec2 half_ = 0.5 * wfvViewport.zw;
  vec2 centre = half_ * wfvTile.zw;
  float side = wfvHere().x < centre.x ? -1.0 : 1.0;
  int j = i == 2 ? 0 : i + 1;
  int k = i == 0 ? 2 : i - 1;
  // a corner on the seam is on both sides
  a.x = (wfvMode & (256 << j)) != 0 ? centre.x + side * abs(a.x - centre.x) : a.x;
  b.x = (wfvMode & (256 << k)) != 0 ? centre.x + side * abs(b.x - centre.x) : b.x;
  bool hereA = (a.x - centre.x) * side >= 0.0;
  bool hereB = (b.x - centre.x) * side >= 0.0;
  bool crosses = (wfvMode & (16 << i)) != 0;
  if (!crosses && !(hereA && hereB))
  {
    return false;
  }
  vec2 seam = vec2(centre.x + side * (wfvSeam.w - centre.x), wfvSeam[i]);
  a = hereA ? a : seam;
  b = hereB ? b : seam;
  return true;
}
