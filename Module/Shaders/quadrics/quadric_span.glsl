// SPDX-License-Identifier: BSD-3-Clause
// Covers a span: all spheres between one sphere and another. Seen from the eye it follows an
// arc of a great circle, which one cap would cover with much to spare: in pieces, a cap
// each. A pixel in two caps is drawn by the piece that holds what its ray meets.

// An arc shorter than this, radians, is not worth another piece.
const float WFV_PIECE_ANGLE = 0.1;

// Least distance of the segment from the eye.
float wfvNearest(vec3 p, vec3 q)
{
  vec3 d = q - p;
  float l2 = dot(d, d);
  float t = l2 > 0.0 ? clamp(-dot(p, d) / l2, 0.0, 1.0) : 0.0;
  return wfvLength(p + t * d);
}

float wfvAngleBetween(vec3 p, vec3 q)
{
  return wfvAtan2(wfvLength(cross(p, q)), dot(p, q));
}

// Angular radius of the spheres along p, q, each with its cap; half a turn where one holds the eye.
float wfvSpanAngle(vec3 p, vec3 q, float radius)
{
  return wfvSphereAngle(vec4(wfvNearest(p, q), 0.0, 0.0, radius));
}

void wfvCoverPiece(vec4 first, vec4 last, float from, float to)
{
  vec4 p = mix(first, last, from);
  vec4 q = mix(first, last, to);
  vec3 middle = p.xyz / wfvLength(p.xyz) + q.xyz / wfvLength(q.xyz);
  float angle =
    0.5 * wfvAngleBetween(p.xyz, q.xyz) + wfvSpanAngle(p.xyz, q.xyz, max(p.w, q.w));
  wfvShareHere = vec2(from, to);
  wfvCoverCap(middle, angle, true);
}

void wfvCoverSpan(vec4 first, vec4 last)
{
  float width = max(first.w, last.w);
  float lf = wfvLength(first.xyz);
  float ll = wfvLength(last.xyz);
  float far = max(lf + first.w, ll + last.w);
  float near = wfvNearest(first.xyz, last.xyz) - width;
  if (!(width > 0.0) || !(far >= wfvView.radii.x / wfvScale()) ||
    !(near - wfvBaselineRadius() <= wfvView.radii.y / wfvScale()))
  {
    return;
  }
  wfvShareHere = vec2(0.0, 1.0);
  float across = wfvSpanAngle(first.xyz, last.xyz, width);
  if (!(across < 0.5 * WFV_PI))
  {
    wfvEmitWindow(near > 0.0);
    return;
  }
  float arc = wfvAngleBetween(first.xyz, last.xyz);
  int n = int(clamp(ceil(arc / max(WFV_PIECE_ANGLE, across)), 1.0, float(WFV_PIECES)));
  float before = 0.0;
  for (int i = 1; i <= n; i++)
  {
    float s = float(i) / float(n);
    float next = i < n ? s * lf / (s * lf + (1.0 - s) * ll) : 1.0;
    wfvCoverPiece(first, last, before, next);
    before = next;
  }
}
