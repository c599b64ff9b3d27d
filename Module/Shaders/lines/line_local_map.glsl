// SPDX-License-Identifier: BSD-3-Clause
// Fragment side of lines on direction maps, technique exact: the point of an arc that is nearest in
// the pixel's local map (local_map.glsl), in which arcs are straight.

vec2 wfvLocalPlace = vec2(0.0); // the pixel's centre, pixels of the tile from its centre

// Takes the place at the angle a for the nearest one if it is.
void wfvTryEnd(float a, vec3 d)
{
  vec3 to = wfvInLocalMap(wfvArcAt(a), d);
  float distance_ = length(to.xy);
  if (to.z > 0.0 && distance_ < wfvBestDistance)
  {
    wfvBestDistance = distance_;
    wfvBestOffset = -to.xy;
    wfvBestAngle = a;
  }
}

// Distance of the place so many pixels beside the centre from the line.
float wfvDistanceFrom(vec2 offset)
{
  vec3 d = wfvLocalDirection(offset);
  vec3 n = cross(wfvArcTop, wfvArcSide);
  vec2 slope = vec2(dot(n, wfvLocal.x), dot(n, wfvLocal.y));
  vec2 foot = -dot(n, d) / max(dot(slope, slope), 1e-30) * slope;
  vec3 seen = wfvLocalDirection(offset + foot);
  float a = wfvAtan2(dot(seen, wfvArcSide), dot(seen, wfvArcTop));
  a = wfvNearestTurn(a, 0.5 * (wfvArcEnds.x + wfvArcEnds.y));
  wfvBestDistance = 1e9;
  if (wfvLineKind == 2 && a > wfvArcEnds.x && a < wfvArcEnds.y)
  {
    wfvBestDistance = length(foot);
    wfvBestOffset = -foot;
    wfvBestAngle = a;
    return wfvBestDistance;
  }
  wfvTryEnd(wfvArcEnds.x, d);
  wfvTryEnd(wfvArcEnds.y, d);
  return wfvBestDistance;
}

float wfvFindNearest(vec2 p)
{
  wfvTakeLocalMap();
  wfvLocalPlace = p;
  float d = wfvDistanceFrom(vec2(0.0));
  bool own = wfvBestAngle >= wfvLineMap.z && wfvBestAngle < wfvLineMap.w;
  return own ? d : 1e9;
}

float wfvSampleDistance(vec2 p)
{
  return wfvDistanceFrom(p - wfvLocalPlace);
}
