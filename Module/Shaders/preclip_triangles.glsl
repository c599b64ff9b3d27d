// Pre-clip of triangles. Each is drawn in one of three ways:
//   as it is      nothing torn, chords good enough;
//   split         it crosses a straight seam: two polygons that meet it exactly
//                 (the paper's rear triangle);
//   covered       it holds a pole or the antipode (the paper's pole triangle), or
//                 bends more than the tolerance: a shape that surely contains its
//                 picture, and the fragment stage decides by the pixel's ray.

layout(triangles) in;
layout(triangle_strip, max_vertices = 10) out;

out vec3 wfvBary;        // barycentric coordinates, used where not covered
flat out vec3 wfvEdge0;  // planes through the eye and the edge opposite to corner i
flat out vec3 wfvEdge1;
flat out vec3 wfvEdge2;
flat out vec4 wfvPlane;  // the triangle's own plane: dot(xyz, p) = w
flat out vec3 wfvSlack;  // pixels by which edge i is widened to meet its chord; < 0: none
flat out int wfvMode;    // bits: 1 covered, 2 4 8 a tie on edge i is inside

// Pixels added round a covering shape, for the rounding of its own bounds.
const float WFV_PAD = 1.5;

// Angle added round a covering shape, radians: float32 rounding of angles.
const float WFV_ANGLE_PAD = 2e-6;

// Relative slack with which a triangle counts as holding a pole.
const float WFV_POLE_SLACK = 1e-5;

vec3 wfvP[3];
int wfvVertexMode;
vec3 wfvN[3];
vec4 wfvT;
vec3 wfvS;
int wfvEmitted;

void wfvEmit(vec4 position, vec3 bary)
{
  gl_Position = position;
  wfvBary = bary;
  // flat outputs count at a strip's third and later vertices only
  if (wfvEmitted > 1)
  {
    wfvEdge0 = wfvN[0];
    wfvEdge1 = wfvN[1];
    wfvEdge2 = wfvN[2];
    wfvPlane = wfvT;
    wfvSlack = wfvS;
    wfvMode = wfvVertexMode;
    wfvWriteCorners();
    gl_PrimitiveID = gl_PrimitiveIDIn;
  }
  wfvEmitted++;
  EmitVertex();
}

void wfvEnd()
{
  EndPrimitive();
  wfvEmitted = 0;
}

vec3 wfvCorner(int i)
{
  return vec3(i == 0 ? 1.0 : 0.0, i == 1 ? 1.0 : 0.0, i == 2 ? 1.0 : 0.0);
}

void wfvEmitWhole(float side)
{
  for (int i = 0; i < 3; i++)
  {
    wfvEmit(wfvClipOnSide(wfvP[i], side), wfvCorner(i));
  }
  wfvEnd();
}

// The part of the triangle on one side of the plane x = 0, as a strip.
void wfvEmitSide(float side)
{
  vec3 p[4];
  vec3 b[4];
  int n = 0;
  for (int i = 0; i < 3; i++)
  {
    int j = i == 2 ? 0 : i + 1;
    float x = side * wfvP[i].x;
    if (x >= 0.0 && n < 4)
    {
      p[n] = wfvP[i];
      b[n] = wfvCorner(i);
      n++;
    }
    if ((x > 0.0 && side * wfvP[j].x < 0.0) || (x < 0.0 && side * wfvP[j].x > 0.0))
    {
      if (n < 4)
      {
        p[n] = wfvSeamPoint(wfvP[i], wfvP[j]);
        b[n] = mix(wfvCorner(i), wfvCorner(j), wfvSeamParameter(wfvP[i], wfvP[j]));
        n++;
      }
    }
  }
  if (n < 3)
  {
    return;
  }
  wfvEmit(wfvClipOnSide(p[0], side), b[0]);
  wfvEmit(wfvClipOnSide(p[1], side), b[1]);
  if (n == 4)
  {
    wfvEmit(wfvClipOnSide(p[3], side), b[3]);
  }
  wfvEmit(wfvClipOnSide(p[2], side), b[2]);
  wfvEnd();
}

// True where the ray from the eye along the axis (index 1: y, 2: z; sign s) meets
// the triangle, ties included.
bool wfvHolds(int axis, float s, float facing)
{
  for (int i = 0; i < 3; i++)
  {
    if (facing * s * wfvN[i][axis] < -WFV_POLE_SLACK * length(wfvN[i]))
    {
      return false;
    }
  }
  return true;
}

// Range of the polar angle (latitude, or theta) over the triangle, and of the azimuth
// unwrapped from the first corner: (azimuth min, polar min, azimuth max, polar max).
vec4 wfvAngularBounds(vec3 pole)
{
  vec2 a[3];
  vec4 r = vec4(1e9, 1e9, -1e9, -1e9);
  for (int i = 0; i < 3; i++)
  {
    a[i] = WFV_ANGLES(wfvP[i]);
    if (i > 0)
    {
      a[i].x = a[i - 1].x + wfvWrap(a[i].x - a[i - 1].x);
    }
    r = vec4(min(r.xy, a[i]), max(r.zw, a[i]));
  }
  // the points of each great circle nearest to and farthest from the poles
  for (int i = 0; i < 3; i++)
  {
    vec3 n = wfvN[i];
    float l2 = dot(n, n);
    vec3 top = l2 > 0.0 ? pole - n * (dot(pole, n) / l2) : pole;
    vec3 p = wfvP[i == 2 ? 0 : i + 1];
    vec3 q = wfvP[i == 0 ? 2 : i - 1];
    for (float s = -1.0; s < 2.0; s += 2.0)
    {
      vec3 e = s * top;
      float slack = 1e-4 * sqrt(l2 * dot(e, e));
      if (dot(cross(p, e), n) >= -slack * length(p) && dot(cross(e, q), n) >= -slack * length(q))
      {
        float polar = WFV_ANGLES(e).y;
        r = vec4(r.x, min(r.y, polar), r.z, max(r.w, polar));
      }
    }
  }
  return r + vec4(-WFV_ANGLE_PAD, -WFV_ANGLE_PAD, WFV_ANGLE_PAD, WFV_ANGLE_PAD);
}

void wfvEmitRectangle(vec4 angles, bool front)
{
  vec2 pad = 2.0 * WFV_PAD / (wfvViewport.zw * wfvTile.xy);
  vec4 r = wfvBounds(angles, wfvView);
  r = vec4(max(r.xy - pad, vec2(-1.0)), min(r.zw + pad, vec2(1.0)));
  if (r.x >= r.z || r.y >= r.w)
  {
    return;
  }
  for (int i = 0; i < 4; i++)
  {
    bool right = front ? (i & 1) != 0 : (i & 2) != 0;
    bool top = front ? (i & 2) != 0 : (i & 1) != 0;
    vec2 p = vec2(right ? r.z : r.x, top ? r.w : r.y);
    wfvEmit(vec4(p * wfvTile.xy + wfvTile.zw, 0.0, 1.0), vec3(0.0));
  }
  wfvEnd();
}

#if WFV_MERIDIAN
void wfvCover(bool front, float facing)
{
  bool north = wfvHolds(1, 1.0, facing);
  bool south = wfvHolds(1, -1.0, facing);
  vec4 a = wfvAngularBounds(vec3(0.0, 1.0, 0.0));
  a = vec4(a.x, south ? -0.5 * WFV_PI : max(a.y, -0.5 * WFV_PI), a.z,
    north ? 0.5 * WFV_PI : min(a.w, 0.5 * WFV_PI));
  if (north || south || a.z - a.x >= 2.0 * WFV_PI)
  {
    wfvEmitRectangle(vec4(-WFV_PI, a.y, WFV_PI, a.w), front);
    return;
  }
  float turn = 2.0 * WFV_PI;
  wfvEmitRectangle(vec4(max(a.x, -WFV_PI), a.y, min(a.z, WFV_PI), a.w), front);
  if (a.z > WFV_PI)
  {
    wfvEmitRectangle(vec4(-WFV_PI, a.y, a.z - turn, a.w), front);
  }
  else if (a.x < -WFV_PI)
  {
    wfvEmitRectangle(vec4(a.x + turn, a.y, WFV_PI, a.w), front);
  }
}
#else
// A ring sector in four pieces: chords outside the outer circle, inside the inner.
void wfvCover(bool front, float facing)
{
  const int pieces = 4;
  bool centre = wfvHolds(2, -1.0, facing);
  bool antipode = wfvHolds(2, 1.0, facing);
  vec4 a = wfvAngularBounds(vec3(0.0, 0.0, 1.0));
  a = vec4(a.x, centre ? 0.0 : max(a.y, 0.0), a.z, antipode ? WFV_PI : a.w);
  a.w = min(a.w, min(WFV_PI, wfvView.maxAngle + WFV_ANGLE_PAD));
  if (a.y > a.w)
  {
    return;
  }
  vec2 size = 0.5 * wfvViewport.zw * wfvTile.xy;
  float pixels = min(size.x * wfvView.scale.x, size.y * wfvView.scale.y);
  float inner = max(0.0, wfvRadius(a.y, wfvView) - WFV_PAD / pixels);
  float outer = wfvRadius(a.w, wfvView) + WFV_PAD / pixels;
  float pad = WFV_PAD / max(inner * pixels, 1e-6);
  bool whole = centre || antipode || pad > 0.5 || a.z - a.x + 2.0 * pad >= 2.0 * WFV_PI;
  float u0 = whole ? -WFV_PI : a.x - pad;
  float du = (whole ? 2.0 * WFV_PI : a.z - a.x + 2.0 * pad) / float(pieces);
  outer = outer / cos(0.5 * du);
  for (int i = 0; i <= pieces; i++)
  {
    float u = u0 + du * float(i);
    vec2 d = vec2(cos(u), sin(u)) * wfvView.scale;
    vec2 first = d * (front ? inner : outer);
    vec2 second = d * (front ? outer : inner);
    wfvEmit(vec4(first * wfvTile.xy + wfvTile.zw, 0.0, 1.0), vec3(0.0));
    wfvEmit(vec4(second * wfvTile.xy + wfvTile.zw, 0.0, 1.0), vec3(0.0));
  }
  wfvEnd();
}
#endif

// Plane through the eye and the edge p, q, the same to the last bit from both sides.
vec3 wfvEdgePlane(vec3 p, vec3 q)
{
  return wfvOrdered(p, q) ? cross(p, q - p) : -cross(q, p - q);
}

// True where the triangle reaches the plane x = 0 behind the eye.
bool wfvReachesSeam()
{
  for (int i = 0; i < 3; i++)
  {
    vec3 p = wfvP[i];
    vec3 q = wfvP[i == 2 ? 0 : i + 1];
    bool on = p.x == 0.0 && p.z > 0.0;
    bool crosses = (p.x < 0.0 && q.x > 0.0) || (p.x > 0.0 && q.x < 0.0);
    if (on || (crosses && wfvSeamPoint(p, q).z > 0.0))
    {
      return true;
    }
  }
  return false;
}

void main()
{
  wfvEmitted = 0;
  for (int i = 0; i < 3; i++)
  {
    wfvP[i] = wfvTilt(gl_in[i].gl_Position.xyz, wfvView) / wfvScale();
  }
  wfvN[0] = wfvEdgePlane(wfvP[1], wfvP[2]);
  wfvN[1] = wfvEdgePlane(wfvP[2], wfvP[0]);
  wfvN[2] = wfvEdgePlane(wfvP[0], wfvP[1]);
  vec3 normal = cross(wfvP[1] - wfvP[0], wfvP[2] - wfvP[0]);
  wfvT = vec4(normal, dot(normal, wfvP[0]));
  // seen edge-on, or not a number: it covers no pixel
  if (!(abs(wfvT.w) > 0.0))
  {
    return;
  }
  float facing = wfvT.w > 0.0 ? 1.0 : -1.0;
  wfvS = vec3(wfvChordError(wfvP[1], wfvP[2]), wfvChordError(wfvP[2], wfvP[0]),
    wfvChordError(wfvP[0], wfvP[1]));
  bool cover = min(wfvS.x, min(wfvS.y, wfvS.z)) < 0.0;
#if WFV_MERIDIAN
  cover = cover || wfvHolds(1, 1.0, facing) || wfvHolds(1, -1.0, facing);
  bool seam = wfvReachesSeam();
#if !WFV_STRAIGHT_SEAM
  cover = cover || seam;
#endif
#else
  cover = cover || wfvHolds(2, 1.0, facing);
#endif
  wfvVertexMode = 0;
  if (cover)
  {
    int ties = (wfvOrdered(wfvP[1], wfvP[2]) == (facing > 0.0) ? 2 : 0) +
      (wfvOrdered(wfvP[2], wfvP[0]) == (facing > 0.0) ? 4 : 0) +
      (wfvOrdered(wfvP[0], wfvP[1]) == (facing > 0.0) ? 8 : 0);
    wfvVertexMode = 1 + ties;
    wfvCover(facing < 0.0, facing);
    return;
  }
#if WFV_MERIDIAN
  float low = min(wfvP[0].x, min(wfvP[1].x, wfvP[2].x));
  float high = max(wfvP[0].x, max(wfvP[1].x, wfvP[2].x));
  if (seam && low < 0.0 && high > 0.0)
  {
    wfvEmitSide(1.0);
    wfvEmitSide(-1.0);
    return;
  }
  wfvEmitWhole(seam ? (high > 0.0 ? 1.0 : -1.0) : 0.0);
#else
  wfvEmitWhole(0.0);
#endif
}
