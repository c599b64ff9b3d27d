// SPDX-License-Identifier: BSD-3-Clause
// Pre-clip of lines: split at the seam and at the point nearest to a pole or the
// antipode, then in as many pieces as the tolerance asks, up to the fixed number that
// every OpenGL 3.2 can emit.

layout(lines) in;
#if WFV_WIDE_LINES
layout(triangle_strip, max_vertices = 40) out;
uniform vec2 lineWidthNVC; // set by the stock mapper: width in NDC, twice
const int WFV_MAX_PIECES = 4;
#else
layout(line_strip, max_vertices = 36) out;
const int WFV_MAX_PIECES = 8;
#endif

vec3 wfvP[2] = vec3[2](vec3(0.0), vec3(0.0));

vec3 wfvAxis(vec3 p) // of the family, on the side of p
{
#if WFV_MERIDIAN
  return vec3(0.0, p.y < 0.0 ? -1.0 : 1.0, 0.0);
#else
  return vec3(0.0, 0.0, 1.0);
#endif
}

bool wfvHasNoAzimuth(vec3 p)
{
#if WFV_FACES
  return false;
#endif
  vec3 axis = wfvAxis(p);
  return dot(p, axis) > 0.0 && wfvAtPole(p, axis);
}

// A point of the stretch in the map; at a pole it takes the azimuth of the stretch.
vec4 wfvLinePoint(vec3 p, vec3 middle, float side)
{
  if (!wfvHasNoAzimuth(p))
  {
    return wfvClipOnSide(p, side);
  }
  vec2 angles = vec2(WFV_ANGLES(middle).x, WFV_ANGLES(wfvAxis(p)).y);
#if WFV_MERIDIAN
  angles.x = side == 0.0 ? angles.x : side * abs(angles.x);
#endif
  return wfvClip(wfvMap(angles, wfvView), wfvLength(p) * wfvScale());
}

void wfvEmitPoint(vec4 position, float t)
{
  gl_Position = position;
  wfvWriteMix(t);
  gl_PrimitiveID = gl_PrimitiveIDIn;
  EmitVertex();
}

#if WFV_WIDE_LINES
// Two points across the line at `at`, whose direction in the picture is from - to.
void wfvEmitAcross(vec4 at, vec4 from, vec4 to, float t)
{
  vec2 d = (to.xy / to.w - from.xy / from.w) / lineWidthNVC;
  float l = length(d);
  vec2 across = l > 0.0 ? vec2(-d.y, d.x) / l : vec2(0.0, 1.0);
  vec2 shift = 0.5 * across * lineWidthNVC * at.w;
  wfvEmitPoint(vec4(at.xy + shift, at.z, at.w), t);
  wfvEmitPoint(vec4(at.xy - shift, at.z, at.w), t);
}
#endif

// Parameter of the point s (0 to 1) of equal steps in the picture of a line whose ends
// are la and lb from the eye.
float wfvStep(float s, float la, float lb)
{
  return s * la / (s * la + (1.0 - s) * lb);
}

// One stretch of the line, from parameter t0 to t1, on one side of the seam.
void wfvEmitStretch(float t0, float t1, float side)
{
  if (!(t1 > t0))
  {
    return;
  }
  vec3 a = mix(wfvP[0], wfvP[1], t0);
  vec3 b = mix(wfvP[0], wfvP[1], t1);
  float la = length(a);
  float lb = length(b);
  vec3 middle = a / la + b / lb;
#if WFV_MERIDIAN
  // on the seam itself the sign of x is noise: one side for the whole stretch
  if (side == 0.0 && middle.z > 0.0 && min(a.z / la, b.z / lb) >= -WFV_AT_POLE)
  {
    side = middle.x < 0.0 ? -1.0 : 1.0;
  }
#endif
  float error = wfvEdgeError(a / la, b / lb);
  int n = clamp(int(ceil(sqrt(error / wfvTolerance))), 1, WFV_MAX_PIECES);
  vec4 before = wfvLinePoint(a, middle, side);
  vec4 here = before;
  for (int i = 0; i <= n; i++)
  {
    float u = wfvStep(float(i) / float(n), la, lb);
    float next = wfvStep(float(i + 1) / float(n), la, lb);
    vec4 after = i < n ? wfvLinePoint(mix(a, b, min(next, 1.0)), middle, side) : here;
#if WFV_WIDE_LINES
    wfvEmitAcross(here, before, after, mix(t0, t1, u));
#else
    wfvEmitPoint(here, mix(t0, t1, u));
#endif
    before = here;
    here = after;
  }
  EndPrimitive();
}

// Parameter of the point of the line nearest to the axis, inside ]0, 1[, or -1.
float wfvNearestToAxis()
{
  vec3 axis = wfvAxis(wfvP[0] + wfvP[1]);
  vec3 a = wfvP[0] - axis * dot(wfvP[0], axis);
  vec3 d = wfvP[1] - wfvP[0];
  d = d - axis * dot(d, axis);
  float t = dot(d, d) > 0.0 ? -dot(a, d) / dot(d, d) : -1.0;
  bool ahead = dot(mix(wfvP[0], wfvP[1], t), axis) > 0.0;
  return t > 0.001 && t < 0.999 && ahead ? t : -1.0;
}

// A stretch on one side of the seam, broken where it comes nearest to a pole.
void wfvEmitBroken(float t0, float t1, float side)
{
  float t = wfvNearestToAxis();
  if (t > t0 && t < t1)
  {
    wfvEmitStretch(t0, t, side);
    wfvEmitStretch(t, t1, side);
    return;
  }
  wfvEmitStretch(t0, t1, side);
}

#if WFV_FACES
void wfvEmitOnFaces(); // lines_faces.glsl
#elif WFV_SAMPLED
void wfvEmitSampled(); // lines_sampled.glsl
#endif

void main()
{
  for (int i = 0; i < 2; i++)
  {
    wfvP[i] = wfvTilt(gl_in[i].gl_Position.xyz, wfvView) / wfvScale();
  }
  bool number = dot(wfvP[0], wfvP[0]) > 0.0 && dot(wfvP[1], wfvP[1]) > 0.0;
  if (!number)
  {
    return;
  }
#if WFV_MERIDIAN
  float a = wfvP[0].x;
  float b = wfvP[1].x;
  bool crosses = (a < 0.0 && b > 0.0) || (a > 0.0 && b < 0.0);
  if (crosses && wfvSeamPoint(wfvP[0], wfvP[1]).z > 0.0)
  {
    float t = wfvSeamParameter(wfvP[0], wfvP[1]);
    wfvEmitBroken(0.0, t, a > 0.0 ? 1.0 : -1.0);
    wfvEmitBroken(t, 1.0, b > 0.0 ? 1.0 : -1.0);
    return;
  }
  bool touches = (a == 0.0 && wfvP[0].z > 0.0) || (b == 0.0 && wfvP[1].z > 0.0);
  wfvEmitBroken(0.0, 1.0, touches ? (a + b < 0.0 ? -1.0 : 1.0) : 0.0);
#elif WFV_FACES
  wfvEmitOnFaces();
#elif WFV_SAMPLED
  wfvEmitSampled();
#else
  wfvEmitBroken(0.0, 1.0, 0.0);
#endif
}
