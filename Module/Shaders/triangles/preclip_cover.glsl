// SPDX-License-Identifier: BSD-3-Clause
// Pre-clip of triangles: a shape that surely contains the picture of a triangle.

// True where the ray from the eye along the axis (index 1: y, 2: z; sign s) meets
// the triangle, ties included.
bool wfvHolds(int axis, float s)
{
  for (int i = 0; i < 3; i++)
  {
    if (s * wfvN[i][axis] < -WFV_POLE_SLACK * length(wfvN[i]))
    {
      return false;
    }
  }
  return true;
}

bool wfvCornerAtPole(vec3 pole)
{
  return wfvAtPole(wfvP[0], pole) || wfvAtPole(wfvP[1], pole) || wfvAtPole(wfvP[2], pole);
}

// Angles of corner i, the azimuth unwrapped from the corner before it; a corner at the
// pole has no azimuth: the one before (or after) tells.
vec2 wfvCornerAngles(int i, vec3 pole, vec2 before)
{
  vec2 a = WFV_ANGLES(wfvP[i]);
  if (wfvAtPole(wfvP[i], pole))
  {
    a.x = i > 0 ? before.x : WFV_ANGLES(wfvP[1]).x;
  }
  else if (i > 0)
  {
    a.x = before.x + wfvWrap(a.x - before.x);
  }
  return a;
}

// Relative slack with which an extreme latitude counts as on its edge.
const float WFV_ARC_SLACK = 1e-4;

// Half an angle of at most 180 degrees over its chord: pi / 4, rounded up.
const float WFV_HALF_ARC = 0.8;

// Range of the polar angle (latitude, or theta) over the triangle, and of the azimuth
// unwrapped from the first corner: (azimuth min, polar min, azimuth max, polar max).
vec4 wfvAngularBounds(vec3 pole)
{
  vec2 a = vec2(0.0);
  vec4 r = vec4(1e9, 1e9, -1e9, -1e9);
  for (int i = 0; i < 3; i++)
  {
    a = wfvCornerAngles(i, pole, a);
    r = vec4(min(r.xy, a), max(r.zw, a));
  }
  // the points of each great circle nearest to and farthest from the poles; no farther
  // from the corners than half an edge, whatever rounding says of an edge seen end-on
  vec4 corners = r;
  float expansion = 0.0;
  for (int i = 0; i < 3; i++)
  {
    vec3 n = wfvT.w > 0.0 ? wfvN[i] : -wfvN[i]; // as p and q turn
    float l2 = dot(n, n);
    vec3 top = l2 > 0.0 ? pole - n * (dot(pole, n) / l2) : pole;
    vec3 p = wfvP[i == 2 ? 0 : i + 1];
    vec3 q = wfvP[i == 0 ? 2 : i - 1];
    expansion = max(expansion, WFV_HALF_ARC * length(p / length(p) - q / length(q)));
    for (float s = -1.0; s < 2.0; s += 2.0)
    {
      vec3 e = s * top;
      float slack = WFV_ARC_SLACK * sqrt(l2 * dot(e, e));
      if (dot(cross(p, e), n) >= -slack * length(p) && dot(cross(e, q), n) >= -slack * length(q))
      {
        float polar = WFV_ANGLES(e).y;
        r = vec4(r.x, min(r.y, polar), r.z, max(r.w, polar));
      }
    }
  }
  r = vec4(r.x, max(r.y, corners.y - expansion), r.z, min(r.w, corners.w + expansion));
  return r + vec4(-WFV_ANGLE_PAD, -WFV_ANGLE_PAD, WFV_ANGLE_PAD, WFV_ANGLE_PAD);
}

// A parallelogram in the NDC of the tile, wound as the triangle is seen.
void wfvEmitQuad(vec2 corner, vec2 right, vec2 up, bool front)
{
  vec2 first = front ? right : up;
  vec2 second = front ? up : right;
  wfvEmit(vec4(corner, 0.0, 1.0), vec3(0.0));
  wfvEmit(vec4(corner + first, 0.0, 1.0), vec3(0.0));
  wfvEmit(vec4(corner + second, 0.0, 1.0), vec3(0.0));
  wfvEmit(vec4(corner + right + up, 0.0, 1.0), vec3(0.0));
  wfvEnd();
}

// Bounds in the picture of a rectangle of angles, padded.
vec4 wfvPadded(vec4 angles)
{
  vec2 pad = 2.0 * WFV_PAD / (wfvViewport.zw * wfvTile.xy);
  vec4 r = wfvBounds(angles, wfvView);
  return vec4(max(r.xy - pad, -1.0 - wfvView.center), min(r.zw + pad, 1.0 - wfvView.center));
}

void wfvEmitRectangle(vec4 r, bool front)
{
  if (r.x >= r.z || r.y >= r.w)
  {
    return;
  }
  vec2 size = (r.zw - r.xy) * wfvTile.xy;
  wfvEmitQuad(r.xy * wfvTile.xy + wfvTile.zw, vec2(size.x, 0.0), vec2(0.0, size.y), front);
}

// Pixels of the tile, from its centre.
vec2 wfvPixel(vec3 p)
{
#if WFV_NON_CENTRAL
  p = wfvSeenPlace(p);
#endif
  vec4 c = wfvClipOnSide(p, 0.0);
  return 0.5 * wfvViewport.zw * c.xy / c.w;
}

// For the fragment stage: where the chords are; of a triangle that reaches the seam, which
// edges cross it (bits 16, 32, 64 of the mode) and which corners are on it (256, 512, 1024).
void wfvPlaceCorners(bool seam)
{
  wfvSeamPlaces = vec4(0.0);
  for (int i = 0; i < 3; i++)
  {
    wfvC[i] = wfvPixel(wfvP[i]);
    vec3 p = wfvP[i == 2 ? 0 : i + 1];
    vec3 q = wfvP[i == 0 ? 2 : i - 1];
    bool crosses = seam && ((p.x < 0.0 && q.x > 0.0) || (p.x > 0.0 && q.x < 0.0));
    vec3 at = crosses ? wfvSeamPoint(p, q) : vec3(0.0, 0.0, -1.0);
    wfvVertexMode += at.z > 0.0 ? 16 << i : 0;
#if WFV_MERIDIAN && WFV_STRAIGHT_SEAM
    vec4 c = at.z > 0.0 ? wfvClipOnSide(at, 1.0) : vec4(0.0, 0.0, 0.0, 1.0);
    wfvSeamPlaces[i] = 0.5 * wfvViewport.w * c.y / c.w;
    wfvSeamPlaces.w = at.z > 0.0 ? 0.5 * wfvViewport.z * c.x / c.w : wfvSeamPlaces.w;
#endif
    wfvVertexMode += seam && wfvP[i].x == 0.0 && wfvP[i].z > 0.0 ? 256 << i : 0;
  }
  wfvVertexMode += seam ? 128 : 0;
}
