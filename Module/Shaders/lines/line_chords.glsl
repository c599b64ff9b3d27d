// SPDX-License-Identifier: BSD-3-Clause
// Lines as chords, geometry stage: pieces so short that each point of a chord is within the tolerance
// of the point of the line that it stands for. The map is asked for places and nothing else, so that
// one text cuts at seams, at poles, at the faces of a cube, at the tears of a direction map, and where
// the rays of an eye begin in several places: where the image jumps, the strip ends and a new one begins.

// Of few lines the stage is invoked several times for each, where OpenGL can: each time for a part of it.
#ifdef GL_ARB_gpu_shader5
layout(lines, invocations = WFV_RUNS) in;
#define WFV_LINE_RUN gl_InvocationID
#define WFV_LINE_RUNS WFV_RUNS
#else
layout(lines) in;
#define WFV_LINE_RUN 0
#define WFV_LINE_RUNS 1
#endif
#if WFV_WIDE_LINES
layout(triangle_strip, max_vertices = WFV_CHORD_VERTICES) out;
uniform vec2 lineWidthNVC; // set by the stock mapper: width in NDC, twice
#else
layout(line_strip, max_vertices = WFV_CHORD_VERTICES) out;
#endif

// Of the fragment stage, for the depth: where the eye sees this point of the line.
out vec3 wfvPlaceGSOutput;

// Pieces that are tried, at the most.
const int WFV_MOST_TRIES = 400;

void wfvEmitVertex(WfvPlace place, vec2 shift)
{
  gl_Position = vec4(place.clip.xy + shift * place.clip.w, place.clip.zw);
  wfvPlaceGSOutput = place.seen * wfvScale();
  wfvWriteMix(mix(wfvShares.x, wfvShares.y, place.way));
  wfvWriteDirection();
  gl_PrimitiveID = gl_PrimitiveIDIn;
  EmitVertex();
}

// A place of a strip that comes from one place and goes on to another.
void wfvEmitPlace(WfvPlace from, WfvPlace place, WfvPlace to)
{
  wfvPlacesLeft--;
#if WFV_WIDE_LINES
  vec2 d = (to.clip.xy / to.clip.w - from.clip.xy / from.clip.w) / lineWidthNVC;
  float l = length(d);
  vec2 across = 0.5 * lineWidthNVC * (l > 0.0 ? vec2(-d.y, d.x) / l : vec2(0.0, 1.0));
  wfvEmitVertex(place, across);
  wfvEmitVertex(place, -across);
#else
  wfvEmitVertex(place, vec2(0.0));
#endif
}

// Pixels: what is drawn up to a jump goes on by so much. It stops within WFV_BESIDE_JUMP of it, and by the
// hardware's rule a line lacks the pixel that it ends in.
const float WFV_TO_JUMP = 0.2;

WfvPlace wfvAtJump(WfvPlace from, WfvPlace place)
{
#if !WFV_FACES // beside a face another one begins, in the middle of a pixel
  vec2 d = wfvPixelOf(place) - wfvPixelOf(from);
  float l = length(d);
  vec2 more = l > 0.0 ? d * (WFV_TO_JUMP / l) : vec2(0.0);
  place.clip.xy += more * 2.0 / wfvViewport.zw * place.clip.w;
#endif
  return place;
}

// The place between two pieces, which are drawn or not.
void wfvEmitJoint(bool drawn, bool draws, WfvPlace from, WfvPlace place, WfvPlace to)
{
  if (drawn || draws)
  {
    wfvEmitPlace(drawn ? from : place, place, draws ? to : place);
  }
  if (!draws)
  {
    EndPrimitive();
  }
}

// A step is halved until its piece may be drawn, and doubled where it might have been longer.
void wfvEmitPieces()
{
  float s = float(WFV_LINE_RUN) / float(WFV_LINE_RUNS);
  float last = float(WFV_LINE_RUN + 1) / float(WFV_LINE_RUNS);
  float size = last - s;
  WfvPlace before = wfvEndAt(s);
  WfvPlace here = before;
  bool drawing = false;
  bool fits = false;
  for (int i = 0; i < WFV_MOST_TRIES && s < last && wfvPlacesLeft > 1; i++)
  {
    float end = min(s + size, last);
    size = end - s;
    WfvPlace next = wfvEndAt(end);
    int piece = wfvJudgePiece(here, next, size);
    if (piece == WFV_PIECE_TOO_LONG)
    {
      size *= 0.5;
      fits = false;
      continue;
    }
    bool draws = piece == WFV_PIECE_DRAWN;
    wfvEmitJoint(drawing, draws, before, draws ? here : wfvAtJump(before, here), next);
    drawing = draws;
    before = here;
    here = next;
    s = end;
    // behind what was left out nothing is known
    size = !drawing ? last - s : (fits ? 2.0 * size : size);
    fits = true;
  }
  wfvEmitJoint(drawing, false, before, here, here);
}

// Of a map that closes across a straight seam, what is wider than its own pixels is seen on both
// sides of it.
void wfvEmitAround()
{
  wfvEmitPieces();
#if WFV_MERIDIAN && WFV_STRAIGHT_SEAM
  float period = 2.0 * wfvTile.x * wfvMap(vec2(WFV_PI, 0.0), wfvView).x;
  int turns = wfvLineWidth > 1.0 && period < 2.0 * wfvTile.x * 1.001 ? 2 : 0;
  for (int i = 0; i < turns; i++)
  {
    wfvTurned = i == 0 ? period : -period;
    wfvEmitPieces();
  }
  wfvTurned = 0.0;
#endif
}

// From a to b, which have these shares of the line, or the other way.
void wfvEmitStretch(vec3 a, vec3 b, float from, float to)
{
  wfvBackwards = from > to;
  wfvBegin = a;
  wfvWay = b - a;
  wfvLengths = max(vec2(wfvLength(a), wfvLength(b)), 1e-30);
  wfvShares = vec2(from, to);
  wfvEmitAround();
}

// The axis that the map is singular at, on the side of p.
vec3 wfvAxis(vec3 p)
{
#if WFV_MERIDIAN
  return vec3(0.0, p.y < 0.0 ? -1.0 : 1.0, 0.0);
#else
  return vec3(0.0, 0.0, 1.0);
#endif
}

// Share of the point of the line nearest to the axis, from the first end on, or -1 where that is an end.
float wfvNearestToAxis(vec3 p, vec3 q)
{
  vec3 axis = wfvAxis(p + q);
  vec3 a = p - axis * dot(p, axis);
  vec3 d = q - p;
  d = d - axis * dot(d, axis);
  float t = dot(d, d) > 0.0 ? -dot(a, d) / dot(d, d) : -1.0;
  bool ahead = dot(mix(p, q, t), axis) > 0.0;
  return t > 0.0 && t < 1.0 && ahead ? t : -1.0;
}

// Side of the seam that all of a line lies on, whose sign in its coordinates is noise; or 0.
float wfvSideOf(vec3 p, vec3 q)
{
#if WFV_MERIDIAN
  bool on = abs(p.x) <= WFV_AT_POLE * wfvLength(p) && abs(q.x) <= WFV_AT_POLE * wfvLength(q);
  return on && max(p.z, q.z) > 0.0 ? (p.x + q.x < 0.0 ? -1.0 : 1.0) : 0.0;
#else
  return 0.0;
#endif
}

void main()
{
  vec3 p = wfvTilt(gl_in[0].gl_Position.xyz, wfvView) / wfvScale();
  vec3 q = wfvTilt(gl_in[1].gl_Position.xyz, wfvView) / wfvScale();
  bool number = dot(p, p) > 0.0 && dot(q, q) > 0.0;
  if (!number)
  {
    return;
  }
  wfvSide = wfvSideOf(p, q);
#if WFV_FACES || WFV_SAMPLED
  wfvEmitStretch(p, q, 0.0, 1.0);
#else
  float t = wfvNearestToAxis(p, q);
  if (t > 0.0)
  {
    vec3 nearest = mix(p, q, t);
    wfvEmitStretch(nearest, p, t, 0.0);
    wfvEmitStretch(nearest, q, t, 1.0);
    return;
  }
  vec3 axis = wfvAxis(p + q);
  bool first = length(cross(p, axis)) * wfvLength(q) <= length(cross(q, axis)) * wfvLength(p);
  wfvEmitStretch(first ? p : q, first ? q : p, first ? 0.0 : 1.0, first ? 1.0 : 0.0);
#endif
}
