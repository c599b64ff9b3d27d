// SPDX-License-Identifier: BSD-3-Clause
// Fragment side of lines of an eye whose rays begin on a circle: what line_fragment.glsl asks of
// them. Depth is the distance along the ray that sees the nearest point.

flat in vec4 wfvLineFoot;

vec3 wfvLineHitDirection = vec3(0.0); // unit vector from the eye, view coordinates
float wfvLineHitDistance = 0.0; // how far along, scene units
#define WFV_FROM_EYE wfvLineHitDirection
#define WFV_LINE_SEEN wfvLineHitDirection
#define WFV_DISTANCE wfvLineHitDistance

void wfvUnpackNc(vec4 map, bool parts)
{
  wfvArcFoot = wfvLineFoot.x;
  wfvArcDistance = wfvLineFoot.y;
  wfvArcGap = wfvLineFoot.zw;
  wfvTwoTops = parts && map.y < 0.0;
  wfvArcTops = map.zw;
  wfvArcInner = wfvHasGap() && parts && !wfvTwoTops ? map.zw : wfvArcGap;
  wfvArcJump = false;
  wfvSetLine();
}

// The angle of the point of the line that is nearest to the ray of a direction.
float wfvAngleOf(vec3 d)
{
  float c = cos(wfvArcFoot);
  float s = sin(wfvArcFoot);
  vec3 u = c * wfvArcSide - s * wfvArcTop;
  vec3 foot = (c * wfvArcTop + s * wfvArcSide) * wfvArcDistance;
  vec3 n = cross(u, d);
  float x = dot(n, cross(wfvEyeAt(d, wfvView) / wfvScale() - foot, d)) / max(dot(n, n), 1e-30);
  return wfvArcFoot + wfvAtan2(x, wfvArcDistance);
}

// Sets what is seen of the point with this parameter, and its depth.
void wfvSeeLine(float along)
{
  vec3 at = mix(wfvArcEnds.z * wfvNcAhead(wfvArcEnds.x),
    wfvArcEnds.w * wfvNcAhead(wfvArcEnds.y), along);
  WfvRayHit hit = wfvSee(at * wfvScale(), wfvView);
  wfvLineHitDirection = wfvUntilt(hit.direction, wfvView);
  wfvLineHitDistance = hit.distance;
}
