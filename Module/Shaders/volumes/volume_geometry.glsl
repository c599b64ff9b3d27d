// SPDX-License-Identifier: BSD-3-Clause
// Geometry stage of volumes: of all the triangles of VTK's box the first becomes the rectangles
// that surely hold the picture of the volume, no pixel twice. The fragment stage finds where the
// ray of each pixel meets the box.
layout(triangles) in;
layout(triangle_strip, max_vertices = 12) out;

uniform int wfvCovers;
uniform vec4 wfvCover[3]; // NDC of the picture: left, bottom, right, top

// On the near plane, or VTK's depth test would leave out what is behind no surface.
void wfvEmitCorner(vec2 ndc)
{
  gl_Position = vec4(ndc * wfvTile.xy + wfvTile.zw, -1.0, 1.0);
  EmitVertex();
}

void main()
{
  int n = gl_PrimitiveIDIn == 0 ? wfvCovers : 0;
  for (int i = 0; i < n; i++)
  {
    vec4 r = wfvCover[i];
    wfvEmitCorner(r.xy);
    wfvEmitCorner(r.zy);
    wfvEmitCorner(r.xw);
    wfvEmitCorner(r.zw);
    EndPrimitive();
  }
}
