// SPDX-License-Identifier: BSD-3-Clause
// Offsets of the depth that keep lines, points and decals in front of the surface that they lie in.
// VTK measures offsets in the window depth of a perspective, so they are measured in it here, and
// turned into the depth of this view.

// Stock VTK's near plane is at least this share of the far plane away (vtkRenderer).
const float WFV_STOCK_NEAR = 0.001;

// Window depth of stock VTK's perspective at a distance from the eye, scene units.
float wfvStockDepth(float rho)
{
  float far = wfvView.radii.y;
  float near = max(wfvView.radii.x, WFV_STOCK_NEAR * far);
  return (1.0 - near / rho) * (far / (far - near));
}

// How much this view's window depth changes from `depth` on when stock VTK's changes by `by`.
float wfvOffsetOfDepth(float depth, float by)
{
  float far = wfvView.radii.y;
  float near = max(wfvView.radii.x, WFV_STOCK_NEAR * far);
  float inverse = 1.0 / wfvDistanceAt(depth, wfvView) - by * (far - near) / (far * near);
  // what would be beyond the far sphere is on it
  float moved = inverse * far > 1.0 ? 1.0 / inverse : far;
  return wfvDepthOf(max(moved, wfvView.radii.x), wfvView) - depth;
}

// Factor and units of the polygon offset; 0: none.
uniform vec2 wfvPolygonOffset;

// One unit: the smallest difference that a depth buffer of 24 bits keeps.
const float WFV_OFFSET_UNIT = 1.0 / 16777216.0;

// What a polygon offset adds to this view's window depth. To be called by all fragments of a square.
float wfvPolygonOffsetAt(float depth)
{
  if (wfvPolygonOffset.x == 0.0 && wfvPolygonOffset.y == 0.0)
  {
    return 0.0;
  }
  float stock = wfvStockDepth(wfvDistanceAt(depth, wfvView));
  float slope = max(abs(dFdx(stock)), abs(dFdy(stock)));
  return wfvOffsetOfDepth(depth, wfvPolygonOffset.x * slope + wfvPolygonOffset.y * WFV_OFFSET_UNIT);
}
