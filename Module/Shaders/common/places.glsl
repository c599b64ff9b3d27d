// SPDX-License-Identifier: BSD-3-Clause
// Geometry stage of lines and points on direction maps: where in the picture something may show.

// Radians: rounding of angles.
const float WFV_PLACE_PAD = 2e-6;

// Radians that so many pixels take up at the most.
float wfvFootprint(float pixels)
{
  vec2 texels = wfvView.tables.xy / (wfvViewport.zw * wfvTile.xy); // a pixel
  return pixels * wfvView.tables.w * length(texels) + WFV_PLACE_PAD;
}

// Where the map is simple round a cap: the rectangle is all there is, and a direction in the cap is
// found from its middle.
bool wfvIsSimplePlace(WfvPlaces places)
{
  return places.simple && !(places.second.x <= places.second.z);
}

// The place of a direction, pixels of the direction map, from a place near it.
vec3 wfvFindIn(vec4 r, vec2 start, vec3 direction)
{
  vec3 found = wfvFindFrom(start, direction, wfvView);
  vec2 ndc = wfvNdcOfPixel(found.xy, wfvView);
  bool inside = all(greaterThanEqual(ndc, r.xy)) && all(lessThanEqual(ndc, r.zw));
  return vec3(found.xy, inside ? found.z : 1e9);
}

vec2 wfvMiddleOf(vec4 r)
{
  return wfvPixelOfNdc(0.5 * (r.xy + r.zw), wfvView);
}

// Pixels of the direction map by which a pixel that is so far from something, and carries its own
// map on as far as that, may be wrong about it.
float wfvCarriedOn(float texels)
{
  return 4.0 * WFV_CLOSE_CURVATURE * texels * texels;
}
