// SPDX-License-Identifier: BSD-3-Clause
// Lines: what leaves the geometry stage, rectangles in pixels.

layout(lines) in;
layout(triangle_strip, max_vertices = WFV_LINE_VERTICES) out;

flat out vec3 wfvLineTop;  // the frame of the arc and
flat out vec3 wfvLineSide;
flat out vec4 wfvLineEnds; // its ends, as in line_arc.glsl
flat out vec4 wfvLineMap;  // modes 0, 1: the chord, pixels; 2, 3: cut, sagitta, own range
flat out int wfvLineMode;  // 0 chord, 1 gently curved, 2 anything, 3 two dots; on a face: 4, 5
#if WFV_FACES || WFV_FLAT_RIM || WFV_NON_CENTRAL
flat out vec2 wfvLineRange; // the angles that the map, or this face, shows
#endif
#if WFV_NON_CENTRAL
flat out vec4 wfvLineFoot;  // foot, distance and gap of line_noncentral.glsl
#endif

// Pixels added round a shape: where parts share a line, half a pixel's diagonal and the
// rounding of the shape; where one holds it, the rounding alone.
const float WFV_LINE_PAD = 1.5;
const float WFV_LINE_THIN_PAD = 0.1;

vec4 wfvMapOut = vec4(0.0);
int wfvModeOut = 0;
int wfvQuadsLeft = 0;

// A rectangle in pixels of the tile, wound to be seen from its front.
void wfvEmitPixels(vec2 corner, vec2 right, vec2 up)
{
  if (wfvQuadsLeft <= 0)
  {
    return;
  }
  wfvQuadsLeft--;
  vec2 ndc = 2.0 / wfvViewport.zw;
  for (int i = 0; i < 4; i++)
  {
    vec2 p = corner + ((i & 1) != 0 ? right : vec2(0.0)) + ((i & 2) != 0 ? up : vec2(0.0));
    gl_Position = vec4(p * ndc, 0.0, 1.0);
    // flat outputs count at a strip's third and later vertices only
    if (i > 1)
    {
      wfvLineTop = wfvArcTop;
      wfvLineSide = wfvArcSide;
      wfvLineEnds = wfvArcEnds;
      wfvLineMap = wfvMapOut;
      wfvLineMode = wfvModeOut;
#if WFV_FACES
      wfvLineMode += WFV_FACE_UNIT * wfvArcFace;
#endif
#if WFV_FACES || WFV_FLAT_RIM || WFV_NON_CENTRAL
      wfvLineRange = wfvArcRange;
#endif
#if WFV_NON_CENTRAL
      wfvLineFoot = vec4(wfvArcFoot, wfvArcDistance, wfvArcGap);
#endif
      wfvWriteCorners();
      gl_PrimitiveID = gl_PrimitiveIDIn;
    }
    EmitVertex();
  }
  EndPrimitive();
}

// The same, and again on the other side where it reaches across a straight seam.
void wfvEmitRound(vec2 corner, vec2 right, vec2 up)
{
  wfvEmitPixels(corner, right, up);
  float period = wfvPeriod();
  if (period > 0.0)
  {
    float middle = wfvTilePixel(vec2(0.0)).x;
    float low = corner.x + min(right.x, 0.0) + min(up.x, 0.0) - middle;
    float high = corner.x + max(right.x, 0.0) + max(up.x, 0.0) - middle;
    if (low < -0.5 * period)
    {
      wfvEmitPixels(corner + vec2(period, 0.0), right, up);
    }
    if (high > 0.5 * period)
    {
      wfvEmitPixels(corner - vec2(period, 0.0), right, up);
    }
  }
}

// Pixels by which a shape is larger than the line's own middle.
float wfvLineGrow()
{
  return 0.5 * wfvLineWidth + (wfvModeOut < 2 ? WFV_LINE_THIN_PAD : WFV_LINE_PAD);
}

void wfvEmitAlong(vec2 from, vec2 to, float grow)
{
  // an end may be so far away that float32 counts in pixels: from the other one, no farther
  // than past the window
  bool first = dot(from, from) < dot(to, to);
  vec2 near = first ? from : to;
  vec2 chord = first ? to - from : from - to;
  float l = length(chord);
  vec2 along = l > 1e-3 ? chord / l : vec2(1.0, 0.0);
  vec2 across = vec2(-along.y, along.x);
  l = min(l, length(near) + wfvViewport.z + wfvViewport.w);
  wfvEmitRound(
    near - grow * (along + across), (l + 2.0 * grow) * along, 2.0 * grow * across);
}
