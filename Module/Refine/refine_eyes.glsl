// SPDX-License-Identifier: BSD-3-Clause
// Says how far an edge leaves its chord because there are two eyes. GLSL that also compiles as C++,
// before refine_chord.glsl, which says what it needs.

// Tolerances by which an edge leaves its chord because each place of it is seen along a ray that
// begins elsewhere on the circle.
WFV_FN float wfvTurningOf(WFV_END a, WFV_END b)
{
  vec3 way = b.place - a.place;
  vec3 seen = b.seen - a.seen;
  float longest2 = max(dot(seen, seen), dot(way, way)); // beside the circle an edge may be seen shorter
  float height = dot(a.place, wfvUpright(wfvView));
  float level2 = dot(a.place, a.place) - height * height - longest2;
  float r = wfvRefine.circle;
  if (!(level2 > 16.0 * longest2 && level2 > WFV_CIRCLE_FAR * WFV_CIRCLE_FAR * r * r))
  {
    return WFV_FAR_NDC;
  }
  return r * longest2 / level2 / a.distance * wfvRefine.fade * wfvStretchOf(a.seen) /
    wfvRefine.tolerance;
}

// Tolerances by which an edge leaves its chord because the picture is shifted by depth.
WFV_FN float wfvShiftingOf(WFV_END a, WFV_END b)
{
  vec3 way = b.seen - a.seen;
  float length2 = dot(way, way);
  float range = wfvView.radii.y - wfvView.radii.x;
  if (min(a.distance, b.distance) >= 0.999 * wfvView.radii.y)
  {
    return 0.0; // beyond the far sphere the shift is the same
  }
  float steep = abs(a.distance - b.distance) / range;
  float angle = sqrt(length2) / min(a.distance, b.distance);
  float bent = length2 / min(a.distance, b.distance) / range;
  float ndc = wfvRefine.depthBend * (bent + steep * steep);
  vec2 half_ = 0.5 * vec2(wfvPicture.z, wfvPicture.w);
  float moved = angle * wfvStretchOf(a.seen) * wfvRefine.depthBend * steep;
  return 0.25 * (ndc * max(half_.x, half_.y) + 2.0 * moved) / wfvRefine.tolerance;
}

// Tolerances by which it does for either reason.
WFV_FN float wfvBendOf(WFV_END a, WFV_END b)
{
  float bend = wfvRefine.circle > 0.0 ? wfvTurningOf(a, b) : 0.0;
  return bend + (wfvRefine.depthBend > 0.0 ? wfvShiftingOf(a, b) : 0.0);
}
