// SPDX-License-Identifier: BSD-3-Clause
// How the direction changes from pixel to pixel of a direction map (behind ray_fragment.glsl).

// True where this pixel of the picture lies in pixels of the direction map that change
// evenly.
bool wfvIsSimple()
{
  vec2 at = wfvPixelOfNdc(wfvNdcOfPixel(gl_FragCoord.xy), wfvView);
  vec4 here = wfvDirectionTexel(wfvView, wfvNearestIndex(at.x, wfvView.tables.x),
    wfvNearestIndex(at.y, wfvView.tables.y));
  vec2 size = wfvViewport.zw * wfvTile.xy;
  bool fine = size.x >= wfvView.tables.x && size.y >= wfvView.tables.y;
  return fine && (int(here.w) & WFV_PIXEL_SIMPLE) != 0;
}

// The change of direction per pixel along x and y. rim: this pixel is beside a discontinuity of the map.
// There may be one before the next pixel: this one's own slopes, inside it.
mat2x3 wfvQuadSteps(WfvRay ray, out bool rim)
{
  rim = !wfvIsSimple();
  return mat2x3(
    2.0 * (wfvRayAt(vec2(0.25, 0.0)).direction - wfvRayAt(vec2(-0.25, 0.0)).direction),
    2.0 * (wfvRayAt(vec2(0.0, 0.25)).direction - wfvRayAt(vec2(0.0, -0.25)).direction));
}

mat2x3 wfvRaySteps(WfvRay ray, out bool rim)
{
  return wfvQuadSteps(ray, rim);
}
