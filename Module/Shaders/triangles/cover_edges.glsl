// SPDX-License-Identifier: BSD-3-Clause
// Fragment side of the pre-clip: rays of the pixel, and the edge functions of the triangle by them.

#if WFV_CURVED_RAYS
WfvRay wfvSurfaceRay(vec2 offset); // curved_fragment.glsl
#else
// The ray of the map that this pixel sees the surface by.
WfvRay wfvSurfaceRay(vec2 offset)
{
  return wfvRayAt(offset);
}
#endif

// Positive inside.
WFV_EDGE wfvEdgesAt(WFV_EDGE direction)
{
  WFV_EDGE e = WFV_EDGE(dot(direction, wfvEdge0), dot(direction, wfvEdge1), dot(direction, wfvEdge2));
#if WFV_NON_CENTRAL
  // a ray's moment, times the edge, is what it changes to begin elsewhere than in the origin
  vec3 start = wfvStart(direction);
  vec3 moment = cross(start, direction);
  e += vec3(dot(moment, wfvSpan0), dot(moment, wfvSpan1), dot(moment, wfvSpan2));
  wfvTurn = wfvAhead(start) < 0.0 ? -1.0 : 1.0;
  e *= wfvTurn;
#endif
  return e;
}

#if WFV_DOUBLES
// What wfvPixelToMap has too few digits for.
uniform vec2 wfvPixelToMapLow;

// The ray of the pixel's centre in double.
WfvFp64Ray wfvFp64RayAt()
{
  WfvFp64View v;
  v.scale = dvec2(wfvView.scale);
  v.lens = dvec4(wfvView.lens);
  v.lens5 = double(wfvView.lens5);
  v.lensHigh = dvec4(wfvView.lensHigh);
  v.maxAngle = double(wfvView.maxAngle);
#if WFV_SAMPLED
  v.tables = dvec4(wfvView.tables);
#endif
  dvec2 perPixel = dvec2(wfvPixelToMap.zw) + dvec2(wfvPixelToMapLow);
  return wfvFp64RayOfMap(dvec2(gl_FragCoord.xy - wfvPixelToMap.xy) * perPixel, v);
}
#endif

// How they change over a step of the direction.
vec3 wfvEdgeStep(vec3 direction, vec3 step_)
{
#if WFV_NON_CENTRAL
  return wfvEdgesAt(direction + step_) - wfvEdgesAt(direction);
#else
  return vec3(wfvEdgesAt(WFV_EDGE(step_)));
#endif
}

// Barycentric coordinates from the edge functions. Where a triangle is seen edge-on they
// are rounding alone, and may sum up to nothing.
vec3 wfvWeigh(vec3 e)
{
  float sum = e.x + e.y + e.z;
  return sum > 0.0 ? e * (1.0 / sum) : vec3(1.0 / 3.0);
}
