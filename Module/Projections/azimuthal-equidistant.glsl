// SPDX-License-Identifier: BSD-3-Clause
// Azimuthal equidistant (fisheye, dome): the distance from the centre is the angle
// theta from -z, r = theta / (fov/2), or the lens polynomial
// r = c1 theta + c2 theta^2 + .. + c5 theta^5. Source: Bailey, Clothier and Gebbie
// 2006, section 3. Domain: the sphere, or with a lens up to half the field of
// view. Discontinuity: the antipode +z, which becomes the outer circle.

WFV_FN float wfvLens(float t, WfvView v)
{
  return t * (v.lens.x + t * (v.lens.y + t * (v.lens.z + t * (v.lens.w + t * v.lens5))));
}

WFV_FN float wfvLensSlope(float t, WfvView v)
{
  return v.lens.x +
    t * (2.0 * v.lens.y + t * (3.0 * v.lens.z + t * (4.0 * v.lens.w + t * 5.0 * v.lens5)));
}

// Radius in the raw map of the angle theta in radians; the ideal lens has r = theta. What
// a polynomial does beyond the field of view is anybody's guess: there it grows on evenly.
WFV_FN float wfvRadius(float theta, WfvView v)
{
  if (v.lens.x == 0.0)
  {
    return theta;
  }
  float inside = min(theta, v.maxAngle);
  return wfvLens(inside, v) + wfvLensSlope(v.maxAngle, v) * (theta - inside);
}

// The inverse of wfvRadius on [0, maxAngle]: Newton, kept inside a bracket. The lens
// is monotone there (checked when it is set). The first guess is exact at both ends:
// beside them a step from elsewhere leaves the bracket, and is halved time and again.
WFV_FN float wfvTheta(float r, WfvView v)
{
  if (v.lens.x == 0.0)
  {
    return r;
  }
  float low = 0.0;
  float high = v.maxAngle;
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
  return t;
}

WFV_FN float wfvThetaAt(vec2 m, float r, WfvView v)
{
  return wfvTheta(r, v);
}
