// SPDX-License-Identifier: BSD-3-Clause
// Fragment side of lines and points on direction maps: this pixel's own map (wfvOwnMap), carried on
// evenly. What is drawn by it is complete on both sides of any discontinuity.

WfvAround wfvOwn;   // slopes per pixel of the picture
float wfvOwnVolume = 0.0; // of the direction and its slopes

void wfvTakeOwnMap()
{
  wfvOwn = wfvOwnMap(wfvPixelOfNdc(wfvNdcOfPixel(gl_FragCoord.xy), wfvView), wfvView);
  vec2 texels = wfvView.tables.xy / (wfvViewport.zw * wfvTile.xy); // a pixel
  wfvOwn.x *= texels.x;
  wfvOwn.y *= texels.y;
  wfvOwnVolume = dot(wfvOwn.direction, cross(wfvOwn.x, wfvOwn.y));
}

// The direction so many pixels beside the pixel's centre, not of unit length.
vec3 wfvOwnDirection(vec2 beside)
{
  return wfvOwn.direction + beside.x * wfvOwn.x + beside.y * wfvOwn.y;
}

// Where a direction is, pixels from the place in the map that has the direction `from`; z is 0 where
// it lies behind.
vec3 wfvInOwnMap(vec3 direction, vec3 from)
{
  float ahead = dot(direction, cross(wfvOwn.x, wfvOwn.y)) / wfvOwnVolume;
  if (!(ahead > 0.0))
  {
    return vec3(0.0);
  }
  vec3 beside = direction - from; // in whose products the digits of the whole are not lost
  vec2 at = vec2(dot(beside, cross(wfvOwn.y, from)), dot(beside, cross(from, wfvOwn.x)));
  return vec3(at / (wfvOwnVolume * ahead), 1.0);
}
