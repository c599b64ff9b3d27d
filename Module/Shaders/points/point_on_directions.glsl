// SPDX-License-Identifier: BSD-3-Clause
// Points on direction maps, of which nothing is known but their tables: a point of n pixels shows in
// each pixel in whose local map (local_map.glsl) it is in the square of n pixels round the pixel's centre.
// So it is complete on both sides of a discontinuity, or cut there, as everything else is.

layout(points) in;
layout(triangle_strip, max_vertices = 8) out;

uniform float wfvPointSize; // pixels
uniform int wfvFrontCulled; // what is seen from its front is not drawn: points always are

flat out vec3 wfvPointAt;     // its direction
flat out float wfvPointDepth; // window depth, 0 to 1

// Pixels round a rectangle, for rounding and the corners of the direction map's pixels.
const float WFV_POINT_PAD = 1.5;

// What a rectangle of the picture shows of it, grown by pixels.
void wfvEmitRectangle(vec4 r, vec2 pixels, vec3 direction, float depth)
{
  if (!(r.x <= r.z && r.y <= r.w))
  {
    return;
  }
  vec2 grow = 2.0 * pixels / (wfvViewport.zw * wfvTile.xy);
  vec2 low = r.xy - grow;
  vec2 high = r.zw + grow;
  for (int i = 0; i < 4; i++)
  {
    int right = wfvFrontCulled != 0 ? 2 : 1;
    vec2 at = vec2((i & right) != 0 ? high.x : low.x, (i & (3 - right)) != 0 ? high.y : low.y);
    gl_Position = vec4(at * wfvTile.xy + wfvTile.zw, 0.0, 1.0);
    wfvPointAt = direction;
    wfvPointDepth = depth;
    wfvWriteCorners();
    gl_PrimitiveID = gl_PrimitiveIDIn;
    EmitVertex();
  }
  EndPrimitive();
}

void main()
{
  vec3 p = wfvTilt(gl_in[0].gl_Position.xyz, wfvView);
  float rho = wfvLength(p);
  float depth = wfvDepthOf(rho, wfvView);
  if (!(rho > 0.0 && depth >= 0.0 && depth <= 1.0))
  {
    return;
  }
  vec3 direction = p / rho;
  float half_ = 0.5 * wfvPointSize;
  WfvPlaces places = wfvCapPlaces(direction, wfvFootprint(1.5 * half_), wfvView); // of its corners
  vec3 found = vec3(0.0, 0.0, 1e9);
  if (wfvIsSimplePlace(places))
  {
    found = wfvFindIn(places.first, wfvMiddleOf(places.first), direction);
  }
  if (found.z < WFV_SEARCH_REST)
  {
    vec2 at = wfvNdcOfPixel(found.xy, wfvView);
    vec2 texel = wfvViewport.zw * wfvTile.xy / wfvView.tables.xy; // pixels
    vec2 grow = half_ + wfvCarriedOn(1.5 * half_ / min(texel.x, texel.y)) * texel + WFV_POINT_PAD;
    wfvEmitRectangle(vec4(at, at), grow, direction, depth);
    return;
  }
  places = wfvApart(places);
  wfvEmitRectangle(places.first, vec2(WFV_POINT_PAD), direction, depth);
  wfvEmitRectangle(places.second, vec2(WFV_POINT_PAD), direction, depth);
}
