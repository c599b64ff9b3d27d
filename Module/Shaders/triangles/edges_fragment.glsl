// SPDX-License-Identifier: BSD-3-Clause
// Surface with edges: those of the original triangle, so that what the pre-clip cuts shows no
// new edge.
uniform float lineWidth; // pixels, set by the stock mapper
uniform vec3 edgeColor;  // set by the stock mapper
#if WFV_EDGE_OPACITY
uniform float edgeOpacity; // likewise
#else
const float edgeOpacity = 1.0; // of a VTK that knows none
#endif
#if WFV_EDGE_FLAGS
uniform samplerBuffer edgeTexture; // bits 1, 2, 4: edge 01, 12, 20 is one of the cell's own
#endif

// How much of the edge colour shows here, 0 to 1.
float wfvEdgeMix()
{
  vec3 d = wfvEdgePixels;
#if WFV_EDGE_FLAGS
  int flags = int(255.0 * texelFetch(edgeTexture, gl_PrimitiveID + PrimitiveIDOffset).r + 0.5);
  d.z = (flags & 1) != 0 ? d.z : 1e9;
  d.x = (flags & 2) != 0 ? d.x : 1e9;
  d.y = (flags & 4) != 0 ? d.y : 1e9;
#endif
  return edgeOpacity * clamp(0.5 + 0.5 * lineWidth - min(d.x, min(d.y, d.z)), 0.0, 1.0);
}
