// SPDX-License-Identifier: BSD-3-Clause
// Fragment side of lines and points on direction maps: this pixel's local map (wfvLocalMap), carried on
// evenly. What is drawn by it is complete on both sides of any discontinuity.

WfvAround wfvLocal;   // slopes per pixel of the picture
float wfvLocalVolume = 0.0; // of the direction and its slopes

void wfvTakeLocalMap()
{
  wfvLocal = wfvLocalMap(wfvPixelOfNdc(wfvNdcOfPixel(gl_FragCoord.xy), wfvView), wfvView);
  vec2 texels = wfvView.tables.xy / (wfvViewport.zw * wfvTile.xy); // a pixel
  wfvLocal.x *= texels.x;
  wfvLocal.y *= texels.y;
  wfvLocalVolume = dot(wfvLocal.direction, cross(wfvLocal.x, wfvLocal.y));
}

// The direction so many pixels beside the pixel's centre, not of unit length.
vec3 wfvLocalDirection(vec2 beside)
{
  return wfvLocal.direction + beside.x * wfvLocal.x + beside.y * wfvLocal.y;
}

// Where a direction is, pixels from the place in the map that has the direction `from`; z is 0 where
// it lies behind.
vec3 wfvInLocalMap(vec3 direction, vec3 from)
{
  float ahead = dot(direction, cross(wfvLocal.x, wfvLocal.y)) / wfvLocalVolume;
  if (!(ahead > 0.0))
  {
    return vec3(0.0);
  }
  vec3 beside = direction - from; // in whose products the digits of the whole are not lost
  vec2 at = vec2(dot(beside, cross(wfvLocal.y, from)), dot(beside, cross(from, wfvLocal.x)));
  return vec3(at / (wfvLocalVolume * ahead), 1.0);
}
