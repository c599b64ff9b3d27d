// SPDX-License-Identifier: BSD-3-Clause
// Pre-clip of triangles: shapes that leave the stage. Each triangle is drawn in one of three
// ways (preclip_triangles.glsl decides):
//   as it is      no discontinuity, chords good enough;
//   split         it crosses a straight seam: two polygons that meet it exactly
//                 (the paper's rear triangle);
//   ray-tested    it holds a pole or the antipode (the paper's pole triangle), or
//                 curves more than the tolerance: a shape that surely contains its
//                 picture, and the fragment stage decides by the pixel's ray.

#if WFV_CURVED_RAYS
// curved_cover.glsl
void wfvEmit(vec4 position, vec3 bary);
void wfvEnd();
#else
void wfvEmit(vec4 position, vec3 bary)
{
  wfvEmitVertex(position, bary);
}

void wfvEnd()
{
  wfvEndShape();
}
#endif

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
