// SPDX-License-Identifier: BSD-3-Clause
// Says where an edge of a mesh is split. GLSL that also compiles as C++ (RefineSpace.h), after
// refine_chord.glsl.

// The share of the way from p to q at which it meets the sphere of this radius, p being inside or
// q, but not both.
WFV_FN float wfvShareAtSphere(vec3 p, vec3 q, float radius)
{
  vec3 way = q - p;
  float a = dot(way, way);
  float b = dot(p, way);
  float c = dot(p, p) - radius * radius;
  float root = sqrt(max(0.0, b * b - a * c));
  return max(0.0, min(1.0, (c < 0.0 ? root - b : -root - b) / a));
}

// Length of the place of a point that the eye sees at this factor of the near radius. Rays that begin
// on a circle are shorter than that.
WFV_FN float wfvNearReach(float factor)
{
  return wfvHypot(factor * wfvView.radii.x, wfvRefine.nearCircle);
}

// Horizontal distance from the vertical axis through the middle of the eyes.
WFV_FN float wfvLevelOf(vec3 p)
{
  return length(p - wfvUpright(wfvView) * dot(p, wfvUpright(wfvView)));
}

// The share of the way from a to b at which it is so far from that axis.
WFV_FN float wfvShareAtLevel(WFV_END a, WFV_END b, float level)
{
  vec3 up = wfvUpright(wfvView);
  vec3 p = a.place - up * dot(a.place, up);
  vec3 q = b.place - up * dot(b.place, up);
  float share = wfvShareAtSphere(p, q, level);
  return share > 0.0 && share < 1.0 ? share : 0.5;
}

// Returns the place where an edge is split at the cylinder round the circle of the eyes, inside of
// which no eye sees; 0: it is not split; below 0: this rim does not matter. The part that is left
// out at the rim is smaller than a pixel. With a fade there is no cylinder.
WFV_FN float wfvSplitAtCircle(WFV_END a, WFV_END b, vec3 way)
{
  if (!(a.distance > 0.0 || b.distance > 0.0))
  {
    return 0.0; // what the eye does not see is convex
  }
  float r = wfvRefine.circle;
  float farthest = max(a.reach, b.reach);
  float left = max(WFV_LEAST_UNSEEN * r,
    min(WFV_MOST_UNSEEN * r, wfvRefine.unseen * farthest * farthest));
  float length2 = dot(way, way);
  bool unseen = !(a.distance > 0.0 && b.distance > 0.0);
  if (unseen && length2 <= left * left)
  {
    return 0.0;
  }
  if (!(wfvRefine.nearCircle > 0.0))
  {
    return unseen ? 0.5 : -1.0;
  }
  float nearA = wfvLevelOf(a.place) - r;
  float nearB = wfvLevelOf(b.place) - r;
  if (unseen)
  {
    bool atRim = max(nearA, nearB) <= left;
    return atRim ? 0.0 : wfvShareAtLevel(a, b, r + 0.5 * left);
  }
  // a chord round the rim leaves out what is between it and the rim, one along the axis nothing
  float along = dot(way, wfvUpright(wfvView));
  bool short_ = length2 - along * along <= 8.0 * r * left && farthest <= 2.0 * min(a.reach, b.reach);
  return max(nearA, nearB) <= left && short_ ? 0.0 : -1.0;
}

// The share at which an edge is split at a sphere beyond which float32, or depth, ends; 0: it is not.
WFV_FN float wfvSplitAtFar(WFV_END a, WFV_END b)
{
  float far = wfvView.radii.y;
  float farthest = max(a.reach, b.reach);
  float nearest = min(a.reach, b.reach);
  if (farthest > WFV_BEYOND * far && nearest < 0.5 * WFV_BEYOND * far)
  {
    return wfvShareAtSphere(a.place, b.place, 0.75 * WFV_BEYOND * far);
  }
  bool shifted = wfvRefine.depthBend > 0.0 && farthest > 1.001 * far && nearest < 0.999 * far;
  return shifted ? wfvShareAtSphere(a.place, b.place, far) : 0.0;
}

// Returns where an edge is split: a share of the way from a to b between 0 and 1; 0 where a chord
// stands for it. The bisector of the angle halves the angle that is seen, however near or slanted
// the edge is. To be called with both ends in one order for all triangles at the edge.
WFV_FN float wfvSplitAt(WFV_END a, WFV_END b)
{
  float deep = wfvNearReach(WFV_DEEP);
  float nearest = min(a.reach, b.reach);
  float farthest = max(a.reach, b.reach);
  if (farthest < deep)
  {
    return 0.0; // nothing of it is drawn
  }
  float share = wfvSplitAtFar(a, b);
  if (share > 0.0)
  {
    return share;
  }
  bool unseen = !(a.distance > 0.0 && b.distance > 0.0);
  if (wfvRefine.circle > 0.0 && (unseen || wfvRefine.nearCircle > 0.0))
  {
    share = wfvSplitAtCircle(a, b, b.place - a.place);
    if (share >= 0.0)
    {
      return share;
    }
  }
  if (!unseen && wfvIsShort(a, b))
  {
    return 0.0;
  }
  if (nearest < deep && farthest > wfvNearReach(WFV_INSIDE))
  {
    share = wfvShareAtSphere(a.place, b.place, wfvNearReach(WFV_CUT));
    return share > 0.0 && share < 1.0 ? share : 0.5;
  }
  share = a.distance / (a.distance + b.distance);
  return share > 0.0 && share < 1.0 ? share : 0.0;
}
