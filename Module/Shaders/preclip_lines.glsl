// Pre-clip of lines: split at the seam, then in as many pieces as the tolerance asks,
// up to the fixed number that every OpenGL 3.2 can emit.

layout(lines) in;
#if WFV_WIDE_LINES
layout(triangle_strip, max_vertices = 36) out;
uniform vec2 lineWidthNVC; // set by the stock mapper: width in NDC, twice
const int WFV_MAX_PIECES = 8;
#else
layout(line_strip, max_vertices = 34) out;
const int WFV_MAX_PIECES = 16;
#endif

vec3 wfvP[2];

void wfvEmitPoint(vec4 position, float t)
{
  gl_Position = position;
  wfvWriteMix(t);
  gl_PrimitiveID = gl_PrimitiveIDIn;
  EmitVertex();
}

// One stretch of the line, from parameter t0 to t1, on one side of the seam.
void wfvEmitStretch(float t0, float t1, float side)
{
  vec3 a = mix(wfvP[0], wfvP[1], t0);
  vec3 b = mix(wfvP[0], wfvP[1], t1);
  float error = wfvEdgeError(normalize(a), normalize(b));
  int n = clamp(int(ceil(sqrt(error / wfvTolerance))), 1, WFV_MAX_PIECES);
  float la = length(a);
  float lb = length(b);
  vec4 before = wfvClipOnSide(a, side);
  for (int i = 0; i <= n; i++)
  {
    // equal steps in the picture of a line that runs away from the eye
    float s = float(i) / float(n);
    float u = s * la / (s * la + (1.0 - s) * lb);
    float t = mix(t0, t1, u);
    vec4 p = wfvClipOnSide(mix(a, b, u), side);
#if WFV_WIDE_LINES
    float s2 = (float(i) + 0.5) / float(n);
    float u2 = s2 * la / (s2 * la + (1.0 - s2) * lb);
    vec4 after = i < n ? wfvClipOnSide(mix(a, b, u2), side) : p;
    vec2 d = (after.xy / after.w - before.xy / before.w) / lineWidthNVC;
    float l = length(d);
    vec2 across = l > 0.0 ? vec2(-d.y, d.x) / l : vec2(0.0, 1.0);
    vec2 shift = 0.5 * across * lineWidthNVC * p.w;
    wfvEmitPoint(vec4(p.xy + shift, p.z, p.w), t);
    wfvEmitPoint(vec4(p.xy - shift, p.z, p.w), t);
    before = p;
#else
    wfvEmitPoint(p, t);
#endif
  }
  EndPrimitive();
}

void main()
{
  for (int i = 0; i < 2; i++)
  {
    wfvP[i] = wfvTilt(gl_in[i].gl_Position.xyz, wfvView) / wfvView.radii.y;
  }
  float a = wfvP[0].x;
  float b = wfvP[1].x;
  bool number = dot(wfvP[0], wfvP[0]) > 0.0 && dot(wfvP[1], wfvP[1]) > 0.0;
  if (!number)
  {
    return;
  }
#if WFV_MERIDIAN
  bool crosses = (a < 0.0 && b > 0.0) || (a > 0.0 && b < 0.0);
  if (crosses && wfvSeamPoint(wfvP[0], wfvP[1]).z > 0.0)
  {
    float t = wfvSeamParameter(wfvP[0], wfvP[1]);
    wfvEmitStretch(0.0, t, a > 0.0 ? 1.0 : -1.0);
    wfvEmitStretch(t, 1.0, b > 0.0 ? 1.0 : -1.0);
    return;
  }
  bool touches = (a == 0.0 && wfvP[0].z > 0.0) || (b == 0.0 && wfvP[1].z > 0.0);
  wfvEmitStretch(0.0, 1.0, touches ? (a + b < 0.0 ? -1.0 : 1.0) : 0.0);
#else
  wfvEmitStretch(0.0, 1.0, 0.0);
#endif
}
