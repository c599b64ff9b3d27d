// SPDX-License-Identifier: BSD-3-Clause
// Pre-clip of triangles of an eye whose rays are curves: a shape that holds the picture of the map
// becomes the rectangle that holds it behind the second projection, at every depth of the triangle.

// The shape that is being emitted, NDC of the picture.
vec2 wfvShapeLow = vec2(1e9);
vec2 wfvShapeHigh = vec2(-1e9);

void wfvEmit(vec4 position, vec3 bary)
{
  vec2 ndc = (position.xy / position.w - wfvTile.zw) / wfvTile.xy;
  wfvShapeLow = min(wfvShapeLow, ndc);
  wfvShapeHigh = max(wfvShapeHigh, ndc);
}

void wfvEnd()
{
  // the object ends with the window
  vec2 low = max(wfvShapeLow, vec2(-1.0));
  vec2 high = min(wfvShapeHigh, vec2(1.0));
  wfvShapeLow = vec2(1e9);
  wfvShapeHigh = vec2(-1e9);
  if (low.x > high.x || low.y > high.y)
  {
    return;
  }
  vec2 a = wfvShift(low, wfvDepthsHere.x, wfvView);
  vec2 b = wfvShift(low, wfvDepthsHere.y, wfvView);
  vec2 c = wfvShift(high, wfvDepthsHere.x, wfvView);
  vec2 d = wfvShift(high, wfvDepthsHere.y, wfvView);
  vec2 pad = 2.0 * WFV_PAD / (wfvViewport.zw * wfvTile.xy);
  low = (max(min(a, b) - pad, vec2(-1.0))) * wfvTile.xy + wfvTile.zw;
  high = (min(max(c, d) + pad, vec2(1.0))) * wfvTile.xy + wfvTile.zw;
  bool front = wfvT.w < 0.0;
  wfvEmitVertex(vec4(front ? low : vec2(low.x, high.y), 0.0, 1.0), vec3(0.0));
  wfvEmitVertex(vec4(front ? vec2(high.x, low.y) : high, 0.0, 1.0), vec3(0.0));
  wfvEmitVertex(vec4(front ? vec2(low.x, high.y) : low, 0.0, 1.0), vec3(0.0));
  wfvEmitVertex(vec4(front ? high : vec2(high.x, low.y), 0.0, 1.0), vec3(0.0));
  wfvEndShape();
}

// Depths of the triangle: from its plane or its corners, whichever says more, to the farthest
// corner.
void wfvSetDepths(vec3 lengths)
{
  vec3 edges = vec3(length(wfvP[2] - wfvP[1]), length(wfvP[0] - wfvP[2]), length(wfvP[1] - wfvP[0]));
  float corners = min(lengths.x, min(lengths.y, lengths.z)) - max(edges.x, max(edges.y, edges.z));
  float nearest = max(corners, abs(wfvT.w) / length(wfvT.xyz));
  float farthest = max(lengths.x, max(lengths.y, lengths.z));
  vec2 depths = vec2(wfvDepthOf(0.9999 * nearest * wfvScale(), wfvView),
    wfvDepthOf(1.0001 * farthest * wfvScale(), wfvView));
  wfvDepthsHere = clamp(2.0 * depths - 1.0, vec2(-1.0), vec2(1.0));
}
