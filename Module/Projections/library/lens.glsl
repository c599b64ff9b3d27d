// SPDX-License-Identifier: BSD-3-Clause
// Shared by the round maps of measured lenses: the radius is a polynomial of that of an ideal lens.
// Included after the projection, which brings or shares
//   float wfvIdeal(float theta)       radius of the ideal lens, growing on [0, v.maxAngle]
//   float wfvIdealSlope(float theta)  its first derivative there
//   float wfvIdealTheta(float r)      its inverse
// WFV_LENSED is false in a shader of a view without a lens.

// c1 t + c2 t^2 + .. + c9 t^9.
WFV_FN float wfvLens(float t, WfvView v)
{
  vec4 h = v.lensHigh;
  float high = v.lens5 + t * (h.x + t * (h.y + t * (h.z + t * h.w)));
  return t * (v.lens.x + t * (v.lens.y + t * (v.lens.z + t * (v.lens.w + t * high))));
}

WFV_FN float wfvLensSlope(float t, WfvView v)
{
  vec4 h = v.lensHigh;
  float high = 5.0 * v.lens5 + t * (6.0 * h.x + t * (7.0 * h.y + t * (8.0 * h.z + t * 9.0 * h.w)));
  return v.lens.x + t * (2.0 * v.lens.y + t * (3.0 * v.lens.z + t * (4.0 * v.lens.w + t * high)));
}

// Radius in the raw map of the angle theta in radians. What a polynomial does beyond the field of
// view is anybody's guess: there it grows on evenly.
WFV_FN float wfvRadius(float theta, WfvView v)
{
  if (!WFV_LENSED || v.lens.x == 0.0)
  {
    return wfvIdeal(theta);
  }
  float inside = min(theta, v.maxAngle);
  float slope = wfvLensSlope(wfvIdeal(v.maxAngle), v) * wfvIdealSlope(v.maxAngle);
  return wfvLens(wfvIdeal(inside), v) + slope * (theta - inside);
}

// The inverse of wfvRadius on [0, maxAngle]: Newton, kept inside a bracket. The lens
// is monotone there (checked when it is set). The first guess is exact at both ends:
// beside them a step from elsewhere leaves the bracket, and is halved time and again.
WFV_FN float wfvTheta(float r, WfvView v)
{
  if (!WFV_LENSED || v.lens.x == 0.0)
  {
    return wfvIdealTheta(r);
  }
  float low = 0.0;
  float high = wfvIdeal(v.maxAngle);
  float t = high * min(1.0, r / wfvLens(high, v));
  for (int i = 0; i < WFV_NEWTON_STEPS; i++)
  {
    float e = wfvLens(t, v) - r;
    if (e > 0.0)
    {
      high = t;
    }
    else
    {
      low = t;
    }
    float slope = wfvLensSlope(t, v);
    float next = slope > 0.0 ? t - e / slope : 0.5 * (low + high);
    t = next >= low && next <= high ? next : 0.5 * (low + high);
  }
  return wfvIdealTheta(t);
}

WFV_FN float wfvThetaAt(vec2 m, float r, WfvView v)
{
  return wfvTheta(r, v);
}
