// SPDX-License-Identifier: BSD-3-Clause
// Says whether the chord of an edge stands for the edge. An edge asks its two ends alone, so the two
// triangles at an edge get the same answer, and refined meshes have no cracks.
//
// GLSL that also compiles as C++ (RefineSpace.h). Who includes it brings:
//   refine_types.glsl           before
//   wfvView                     the view, of one eye
//   wfvRefine                   the numbers below
//   wfvSeeEnd(place)            where the eye sees a point of the map's own frame
//   wfvLimitOf(seen)            squared angle of a chord there at the most, radians; 0: look closer
//   wfvStretchOf(seen)          pixels a radian there at the most
//   wfvPixelOf(seen, distance)  place in the picture, pixels; may be anywhere for no place

WFV_FN WfvEnd wfvEndAt(vec3 place)
{
  WfvEnd e = wfvSeeEnd(place);
  e.limit = e.distance > 0.0 ? wfvLimitOf(e.seen) : 0.0;
  return e;
}

// Sine of the angle from a pole or the antipode; 1 where the map has none.
WFV_FN float wfvSingularSine(WfvEnd e)
{
  vec3 d = e.seen / e.distance;
  if (wfvRefine.tears == WFV_TEARS_MERIDIAN)
  {
    return wfvHypot(d.x, d.z);
  }
  return wfvRefine.tears == WFV_TEARS_AZIMUTHAL && d.z > 0.0 ? wfvHypot(d.x, d.y) : 1.0;
}

// The face of the cube that shows a direction: 1 to 6.
WFV_FN int wfvFaceOf(vec3 d)
{
  vec3 a = abs(d);
  if (a.x >= a.y && a.x >= a.z)
  {
    return d.x < 0.0 ? 1 : 2;
  }
  return a.y >= a.z ? (d.y < 0.0 ? 3 : 4) : (d.z < 0.0 ? 5 : 6);
}

// True where the picture of an edge may have a gap. Its chord cannot be judged by its middle then.
WFV_FN bool wfvMayTear(WfvEnd a, WfvEnd b)
{
  if (wfvRefine.tears == WFV_TEARS_MERIDIAN)
  {
    bool along = a.seen.x == 0.0 && b.seen.x == 0.0; // in the plane of the seam
    return !along && a.seen.x * b.seen.x <= 0.0 && max(a.seen.z, b.seen.z) >= 0.0;
  }
  return wfvRefine.tears == WFV_TEARS_FACES && wfvFaceOf(a.seen) != wfvFaceOf(b.seen);
}

// Twice the area between three places of the picture over the tolerance: how far `middle` is from
// the chord, times the chord's length.
WFV_FN bool wfvIsNear(vec2 chord, vec2 off, float share)
{
  float across = abs(chord.x * off.y - chord.y * off.x);
  return WFV_MIDDLE_SAFETY * across <= wfvRefine.tolerance * length(chord) &&
    WFV_MIDDLE_SAFETY * length(off - share * chord) <= WFV_ALONG * wfvRefine.tolerance;
}

// True where the picture of the place at this share of an edge is near the chord of the edge.
WFV_FN bool wfvIsNearAt(WfvEnd a, WfvEnd b, float share)
{
  WfvEnd m = wfvSeeEnd(a.place + (b.place - a.place) * share);
  vec2 from = wfvPixelOf(a.seen, a.distance);
  vec2 chord = wfvPixelOf(b.seen, b.distance) - from;
  return m.distance > 0.0 && wfvIsNear(chord, wfvPixelOf(m.seen, m.distance) - from, share);
}

// Tolerances by which an edge leaves its chord because each place of it is seen along a ray that
// begins elsewhere on the circle. length2: of the edge as it is seen, squared.
WFV_FN float wfvTurningOf(WfvEnd a, WfvEnd b, float length2)
{
  vec3 way = b.place - a.place;
  float longest2 = max(length2, dot(way, way)); // beside the circle an edge may be seen shorter
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
WFV_FN float wfvShiftingOf(WfvEnd a, WfvEnd b, float length2)
{
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
WFV_FN float wfvBendOf(WfvEnd a, WfvEnd b, float length2)
{
  float bend = wfvRefine.circle > 0.0 ? wfvTurningOf(a, b, length2) : 0.0;
  return bend + (wfvRefine.depthBend > 0.0 ? wfvShiftingOf(a, b, length2) : 0.0);
}

// True where the middle of an edge, and of one whose rays begin on a circle its quarters, are so
// near the chord that the edge is.
WFV_FN bool wfvIsNearChord(WfvEnd a, WfvEnd b)
{
  if (!wfvIsNearAt(a, b, 0.5))
  {
    return false;
  }
  return wfvRefine.circle == 0.0 || (wfvIsNearAt(a, b, 0.25) && wfvIsNearAt(a, b, 0.75));
}

// True where an end is so far outside of the map that nothing of a short edge there is drawn.
WFV_FN bool wfvIsOutside(WfvEnd e)
{
  bool ends = wfvRefine.tears == WFV_TEARS_PLANAR || wfvRefine.tears == WFV_TEARS_AZIMUTHAL;
  return ends && -e.seen.z <= wfvRefine.beyondCosine * e.distance;
}

// True where one end of an edge lies before the end of a planar map, and the other beyond.
WFV_FN bool wfvLeavesPlane(WfvEnd a, WfvEnd b)
{
  return wfvRefine.tears == WFV_TEARS_PLANAR && wfvIsOutside(a) != wfvIsOutside(b);
}

WFV_FN bool wfvIsWithinRim(WfvEnd e)
{
  return -e.seen.z > wfvRefine.rimCosine * e.distance;
}

// True where an edge crosses the rim of a round map, where triangles are cut along chords of it.
WFV_FN bool wfvCrossesRim(WfvEnd a, WfvEnd b)
{
  bool within = wfvIsWithinRim(a);
  return wfvRefine.rimChord > 0.0 && within != wfvIsWithinRim(b);
}

// True where both ends of an edge lie beyond a rim of more than 90 degrees, beyond which all is convex.
WFV_FN bool wfvIsBeyondRim(WfvEnd a, WfvEnd b)
{
  return wfvRefine.rimChord > 0.0 && wfvRefine.rimCosine < 0.0 && !wfvIsWithinRim(a) &&
    !wfvIsWithinRim(b);
}

// True where both ends of an edge are seen so near to one another that it is never split.
WFV_FN bool wfvIsTiny(WfvEnd a, WfvEnd b)
{
  vec3 across = cross(a.seen, b.seen);
  float product = a.distance * b.distance;
  return dot(a.seen, b.seen) > 0.0 &&
    dot(across, across) <= wfvRefine.tinyAngle2 * product * product;
}

// True where an edge is short for another reason than its picture: it is smaller than can be seen,
// or lies where nothing is drawn.
WFV_FN bool wfvNeedsNoPicture(WfvEnd a, WfvEnd b, float length2, float nearest2)
{
  bool outside = wfvIsOutside(a) && wfvIsOutside(b);
  return wfvIsTiny(a, b) || wfvIsBeyondRim(a, b) ||
    (outside && length2 <= WFV_OUTSIDE_CHORD * WFV_OUTSIDE_CHORD * nearest2);
}

// True where the middle of an edge that keeps no bound is worth to be projected.
WFV_FN bool wfvMayBeShort(WfvEnd a, WfvEnd b, float length2, float limit2, float nearest2)
{
  if (wfvMayTear(a, b) || !(length2 <= WFV_LONGEST_CHORD * WFV_LONGEST_CHORD * nearest2))
  {
    return false;
  }
  float sine = WFV_NEAR_SINGULARITY * min(wfvSingularSine(a), wfvSingularSine(b));
  return length2 <= WFV_LONGER2 * limit2 ||
    (!(limit2 > 0.0) && length2 <= sine * sine * nearest2);
}

// True where a chord stands for an edge, both of whose ends the eye sees.
WFV_FN bool wfvIsShort(WfvEnd a, WfvEnd b)
{
  vec3 way = b.seen - a.seen;
  float length2 = dot(way, way);
  float nearest2 = min(a.distance, b.distance) * min(a.distance, b.distance);
  if (wfvNeedsNoPicture(a, b, length2, nearest2))
  {
    return true;
  }
  if (wfvCrossesRim(a, b) && !(length2 <= wfvRefine.rimChord * wfvRefine.rimChord * nearest2))
  {
    return false;
  }
  if (wfvLeavesPlane(a, b))
  {
    return length2 <= wfvRefine.endChord * wfvRefine.endChord * nearest2;
  }
  float limit2 = min(a.limit * a.distance * a.distance, b.limit * b.distance * b.distance);
  float bend = limit2 > 0.0 ? wfvBendOf(a, b, length2) : 0.0;
  return length2 + bend * limit2 <= limit2 ||
    (wfvMayBeShort(a, b, length2, limit2, nearest2) && wfvIsNearChord(a, b));
}
