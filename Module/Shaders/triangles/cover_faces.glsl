// SPDX-License-Identifier: BSD-3-Clause
// Covers a triangle for maps of the faces of a cube: for each row of faces the rectangle of
// what the row shows of it. On a face straight edges are straight in the gnomonic picture,
// so its extremes are corners of the triangle cut to the face's frustum.

// By how much, relative, the frustum of a face is widened before it cuts.
const float WFV_FACE_SLACK = 1e-5;

// A triangle cut by four planes has seven corners at the most.
const int WFV_FACE_CORNERS = 7;

#if WFV_NON_CENTRAL
// Radians: what is seen as far as this from where the origin sees it may be on any face.
const float WFV_FACE_GROW = 0.3;

// By how much, at the most, an angle about an axis of the face changes when the direction
// changes by one: 1 / cos of the latitude of the corner of a cube seen under 45 + 17 degrees.
const float WFV_FACE_STEEP = 2.0;
#endif

vec3 wfvPolygon[WFV_FACE_CORNERS];
int wfvPolygonSize = 0;

// Which side of a frustum's plane number k (right, left, above, below) q is on; positive:
// inside. q in the frame of the face.
float wfvFrustumSide(vec3 q, int k)
{
  float sideways = k < 2 ? q.x : q.y;
#if WFV_NON_CENTRAL
  // beyond 45 degrees by what the circle adds, which at a corner of the cube is more about the axis
  float s = WFV_FACE_STEEP * sin(min(wfvGrow, WFV_FACE_GROW));
  float t = s / sqrt((1.0 - s) * (1.0 + s));
  float ahead = wfvGrow < WFV_FACE_GROW ? (1.0 + t) / (1.0 - t) : 1e9;
#else
  const float ahead = 1.0;
#endif
  return q.z * ahead * (1.0 + WFV_FACE_SLACK) + ((k & 1) == 0 ? -sideways : sideways);
}

// Cuts the polygon by one plane of the frustum.
void wfvCutPolygon(int k)
{
  vec3 cut[WFV_FACE_CORNERS];
  int n = 0;
  for (int i = 0; i < wfvPolygonSize; i++)
  {
    vec3 p = wfvPolygon[i];
    vec3 q = wfvPolygon[i + 1 < wfvPolygonSize ? i + 1 : 0];
    float a = wfvFrustumSide(p, k);
    float b = wfvFrustumSide(q, k);
    if (a >= 0.0 && n < WFV_FACE_CORNERS)
    {
      cut[n] = p;
      n++;
    }
    if ((a > 0.0 && b < 0.0) || (a < 0.0 && b > 0.0))
    {
      if (n < WFV_FACE_CORNERS)
      {
        cut[n] = mix(p, q, a / (a - b));
        n++;
      }
    }
  }
  wfvPolygon = cut;
  wfvPolygonSize = n;
}

// The part of the triangle on a face.
void wfvCutToFace(int face)
{
  wfvPolygonSize = 3;
  for (int i = 0; i < 3; i++)
  {
    wfvPolygon[i] = wfvInFace(wfvP[i], face);
  }
  for (int k = 0; k < 4; k++)
  {
    wfvCutPolygon(k);
  }
}

// NDC rectangle of the part of the triangle on a face, clipped to the face; x min above x
// max: none.
vec4 wfvFaceBounds(int face)
{
  vec2 pad = 2.0 * WFV_PAD / (wfvViewport.zw * wfvTile.xy);
  vec2 centre = wfvFaceCentre(face);
  vec2 half_ = vec2(1.0 / 3.0, 0.5);
#if WFV_NON_CENTRAL
  if (!(wfvGrow < WFV_FACE_GROW))
  {
    return vec4(centre - half_, centre + half_);
  }
  pad += half_ * (4.0 / WFV_PI * WFV_FACE_STEEP * wfvGrow);
#endif
  vec4 r = vec4(1e9, 1e9, -1e9, -1e9);
  wfvCutToFace(face);
  for (int i = 0; i < wfvPolygonSize; i++)
  {
    vec3 q = wfvPolygon[i];
    // beside the eye every direction is possible
    bool eye = !(q.z > 1e-6 * max(length(wfvP[0]), max(length(wfvP[1]), length(wfvP[2]))));
    vec2 angle = 4.0 / WFV_PI * vec2(wfvAtan2(q.x, q.z), wfvAtan2(q.y, q.z));
    r = vec4(min(r.xy, eye ? vec2(-1.0) : angle), max(r.zw, eye ? vec2(1.0) : angle));
  }
  r = vec4(centre + r.xy * half_ - pad, centre + r.zw * half_ + pad);
  return vec4(max(r.xy, centre - half_), min(r.zw, centre + half_));
}

void wfvCover(bool front)
{
  for (int row = 0; row < 2; row++)
  {
    vec4 r = vec4(1e9, 1e9, -1e9, -1e9);
    for (int column = 0; column < 3; column++)
    {
      vec4 f = wfvFaceBounds(3 * row + column);
      if (f.x < f.z && f.y < f.w)
      {
        r = vec4(min(r.xy, f.xy), max(r.zw, f.zw));
      }
    }
    if (r.x < r.z)
    {
      vec2 size = (r.zw - r.xy) * wfvTile.xy;
      wfvEmitQuad(r.xy * wfvTile.xy + wfvTile.zw, vec2(size.x, 0.0), vec2(0.0, size.y), front);
    }
  }
}
