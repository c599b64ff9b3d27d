// SPDX-License-Identifier: BSD-3-Clause
// Says whether the chord of an edge stands for the edge. An edge asks its two ends alone, so the two
// triangles at an edge get the same answer, and refined meshes have no cracks.
//
// GLSL that also compiles as C++ (RefineSpace.h). Who includes it brings:
//   refine_types.glsl, refine_eyes.glsl   before
//   WFV_END                     WfvEnd, or a reference to it where the language has one
//   wfvView                     the view, of one eye
//   wfvRefine                   the numbers below
//   wfvSeeEnd(place)            where the eye sees a point of the map's own frame
//   wfvLimitOf(seen)            squared angle of a chord there at the most, radians; 0: look closer
//   wfvStretchOf(seen)          pixels a radian there at the most
//   wfvPixelOf(seen, distance)  place in the picture, pixels; may be anywhere for no place

WFV_FN WfvEnd wfvEndAt(vec3 place)
{
  WfvEnd e = wfvSeeEnd(place);
  bool seen = e.distance > 0.0;
  e.limit = seen ? wfvLimitOf(e.seen) : 0.0;
  e.pixel = seen ? wfvPixelOf(e.seen, e.distance) : vec2(0.0);
  return e;
}

// True where all rays begin at one place and the picture is not shifted by depth. The picture of an
// edge then depends on the directions of its places alone.
WFV_FN bool wfvIsCentral()
{
  return wfvRefine.circle == 0.0 && wfvRefine.depthBend == 0.0;
}

// Squared angle of an edge, radians. For two eyes the distances count as well, so it is the squared
// length, over that of the nearer end.
WFV_FN float wfvAngle2(WFV_END a, WFV_END b)
{
  float nearest = min(a.distance, b.distance);
  if (!wfvIsCentral())
  {
    vec3 way = b.seen - a.seen;
    return dot(way, way) / (nearest * nearest);
  }
  bool steep = max(a.distance, b.distance) > WFV_STEEPEST * nearest;
  vec3 across = cross(a.seen, b.seen);
  float product = a.distance * b.distance;
  bool ahead = !steep && dot(a.seen, b.seen) > 0.0;
  return ahead ? dot(across, across) / (product * product) : WFV_FAR_NDC;
}

// Sine of the angle from a pole, the antipode or the axis of the eyes, whichever is nearest; 1 where
// there is none.
WFV_FN float wfvSingularSine(WFV_END e)
{
  vec3 d = e.seen / e.distance;
  vec3 up = wfvUpright(wfvView);
  float axis = wfvRefine.circle > 0.0 ? length(d - up * dot(d, up)) : 1.0;
  if (wfvRefine.tears == WFV_TEARS_MERIDIAN)
  {
    return min(axis, wfvHypot(d.x, d.z));
  }
  bool behind = wfvRefine.tears == WFV_TEARS_AZIMUTHAL && d.z > 0.0;
  return behind ? min(axis, wfvHypot(d.x, d.y)) : axis;
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
WFV_FN bool wfvMayTear(WFV_END a, WFV_END b)
{
  if (wfvRefine.tears == WFV_TEARS_MERIDIAN)
  {
    bool along = a.seen.x == 0.0 && b.seen.x == 0.0; // in the plane of the seam
    return !along && a.seen.x * b.seen.x <= 0.0 && max(a.seen.z, b.seen.z) >= 0.0;
  }
  return wfvRefine.tears == WFV_TEARS_FACES && wfvFaceOf(a.seen) != wfvFaceOf(b.seen);
}

// Pixels that the chord of an edge may be off. Beside a round rim, along which the rows of a mesh are
// nearer to one another than the tolerance, it is a part of the distance from the rim: chords of two
// rows would cross.
WFV_FN float wfvToleranceOf(WFV_END a, WFV_END b)
{
  float row = wfvRefine.rimPixels - max(length(a.pixel), length(b.pixel));
  float most = wfvRefine.tolerance;
  bool free_ = !(wfvRefine.rimChord > 0.0) || !wfvIsCentral();
  return free_ ? most : max(min(WFV_OF_ROW * row, most), WFV_LEAST_OF_TOLERANCE * most);
}

// True where `off`, a place of the picture from one end of a chord, is this near the place of the
// chord at this share.
WFV_FN bool wfvIsNear(vec2 chord, vec2 off, float share, float tolerance)
{
  float across = abs(chord.x * off.y - chord.y * off.x);
  return WFV_MIDDLE_SAFETY * across <= tolerance * length(chord) &&
    WFV_MIDDLE_SAFETY * length(off - share * chord) <= WFV_ALONG * tolerance;
}

// True where the picture of the place at this share of an edge is near the place of the chord that
// has this share of the values at its ends: the rasterizer interpolates them in perspective.
WFV_FN bool wfvIsNearAt(WFV_END a, WFV_END b, float share, float tolerance)
{
  WfvEnd m = wfvSeeEnd(a.place + (b.place - a.place) * share);
  float along = share * b.distance / ((1.0 - share) * a.distance + share * b.distance);
  return m.distance > 0.0 &&
    wfvIsNear(b.pixel - a.pixel, wfvPixelOf(m.seen, m.distance) - a.pixel, along, tolerance);
}

// True where the middle of an edge, and its quarters where the map curves more the nearer a place is
// to a singularity, are so near the chord that the edge is.
WFV_FN bool wfvIsNearChord(WFV_END a, WFV_END b, float tolerance, bool curves)
{
  float middle = a.distance / (a.distance + b.distance); // of the angle
  return wfvIsNearAt(a, b, middle, tolerance) &&
    (!curves || (wfvIsNearAt(a, b, 0.5 * middle, tolerance) &&
      wfvIsNearAt(a, b, 0.5 + 0.5 * middle, tolerance)));
}

// True where an end is so far outside of the map that nothing of a short edge there is drawn.
WFV_FN bool wfvIsOutside(WFV_END e)
{
  bool ends = wfvRefine.tears == WFV_TEARS_PLANAR || wfvRefine.tears == WFV_TEARS_AZIMUTHAL;
  return ends && -e.seen.z <= wfvRefine.beyondCosine * e.distance;
}

// True where one end of an edge lies before the end of a planar map, and the other beyond.
WFV_FN bool wfvLeavesPlane(WFV_END a, WFV_END b)
{
  return wfvRefine.tears == WFV_TEARS_PLANAR && wfvIsOutside(a) != wfvIsOutside(b);
}

WFV_FN bool wfvIsWithinRim(WFV_END e)
{
  return -e.seen.z > wfvRefine.rimCosine * e.distance;
}

// True where an edge crosses the rim of a round map, where triangles are cut along chords of it.
WFV_FN bool wfvCrossesRim(WFV_END a, WFV_END b)
{
  bool within = wfvIsWithinRim(a);
  return wfvRefine.rimChord > 0.0 && within != wfvIsWithinRim(b);
}

// True where both ends of an edge lie beyond a rim of more than 90 degrees, beyond which all is convex.
WFV_FN bool wfvIsBeyondRim(WFV_END a, WFV_END b)
{
  return wfvRefine.rimChord > 0.0 && wfvRefine.rimCosine < 0.0 && !wfvIsWithinRim(a) &&
    !wfvIsWithinRim(b);
}

// True where both ends of an edge are seen so near to one another that it is never split.
WFV_FN bool wfvIsTiny(WFV_END a, WFV_END b)
{
  vec3 across = cross(a.seen, b.seen);
  float product = a.distance * b.distance;
  return dot(a.seen, b.seen) > 0.0 &&
    dot(across, across) <= wfvRefine.tinyAngle2 * product * product;
}

// True where an edge is short for another reason than its picture: it is smaller than can be seen,
// or lies where nothing is drawn.
WFV_FN bool wfvNeedsNoPicture(WFV_END a, WFV_END b, float angle2)
{
  bool outside = wfvIsOutside(a) && wfvIsOutside(b);
  return wfvIsTiny(a, b) || wfvIsBeyondRim(a, b) ||
    (outside && angle2 <= WFV_OUTSIDE_CHORD * WFV_OUTSIDE_CHORD);
}

// True where the middle of an edge that keeps no bound is worth to be projected.
WFV_FN bool wfvMayBeShort(WFV_END a, WFV_END b, float angle2, float limit, bool curves)
{
  if (wfvMayTear(a, b) || !(angle2 <= WFV_LONGEST_CHORD * WFV_LONGEST_CHORD))
  {
    return false;
  }
  float sine = WFV_NEAR_SINGULARITY * min(wfvSingularSine(a), wfvSingularSine(b));
  return (!curves || angle2 <= sine * sine) &&
    (!(limit > 0.0) || angle2 <= WFV_LONGER2 * limit);
}

// True where a chord stands for an edge, both of whose ends the eye sees.
WFV_FN bool wfvIsShort(WFV_END a, WFV_END b)
{
  float angle2 = wfvAngle2(a, b);
  if (wfvNeedsNoPicture(a, b, angle2))
  {
    return true;
  }
  if (wfvCrossesRim(a, b) && !(angle2 <= wfvRefine.rimChord * wfvRefine.rimChord))
  {
    return false;
  }
  if (wfvLeavesPlane(a, b))
  {
    return angle2 <= wfvRefine.endChord * wfvRefine.endChord;
  }
  float tolerance = wfvToleranceOf(a, b);
  float limit = min(a.limit, b.limit) * (tolerance / wfvRefine.tolerance);
  float bend = limit > 0.0 && !wfvIsCentral() ? wfvBendOf(a, b) : 0.0;
  bool curves = wfvRefine.circle > 0.0 || !(limit > 0.0);
  return angle2 + bend * limit <= limit ||
    (wfvMayBeShort(a, b, angle2, limit, curves) && wfvIsNearChord(a, b, tolerance, curves));
}
