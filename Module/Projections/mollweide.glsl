// SPDX-License-Identifier: BSD-3-Clause
// Mollweide: equal-area, the whole sphere in an ellipse, parallels straight.
// x = 2 sqrt(2) / pi lambda cos(t), y = sqrt(2) sin(t), 2 t + sin(2 t) = pi sin(phi).
// Source: Snyder, Map Projections: A Working Manual (1987), chapter 31.
// Domain: the sphere. Discontinuity: the meridian lambda = +-pi, the border of the ellipse;
// the poles are points.

const float WFV_TOP = 1.4142135623730951;
const float WFV_MOLLWEIDE_WIDTH = 0.90031631615710607; // 2 sqrt(2) / pi

// t from the equator: the equation in 2 t, whose slope stays above 1 there.
WFV_FN float wfvMollweideFromEquator(float s)
{
  float k = WFV_PI * s;
  float a = 0.5 * k;
  for (int i = 0; i < WFV_NEWTON_STEPS; i++)
  {
    vec2 at = wfvSinCos(a);
    float step_ = (a + at.x - k) / (1.0 + at.y);
    a = max(0.0, min(WFV_PI, a - step_));
    if (abs(step_) <= WFV_ROOT_STEP)
    {
      break;
    }
  }
  return 0.5 * a;
}

// pi/2 - t from the pole: w - sin(w) = pi (1 - sin(phi)) in w = pi - 2 t. The cube root
// starts it so near that no step leaves the range.
WFV_FN float wfvMollweideFromPole(float gap)
{
  float k = WFV_PI * gap;
  float c = wfvCbrt(6.0 * k);
  float w = c * (1.0 + c * c / 60.0 * (1.0 + c * c * 3.0 / 70.0));
  for (int i = 0; i < WFV_NEWTON_STEPS && w > 0.0; i++)
  {
    float s = wfvSinCos(0.5 * w).x;
    float step_ = (wfvArcMinusSine(w) - k) / (2.0 * s * s);
    w = max(0.0, min(WFV_PI, w - step_));
    if (abs(step_) <= WFV_ROOT_STEP * w)
    {
      break;
    }
  }
  return 0.5 * w;
}

WFV_FN vec2 wfvParallel(vec2 phi, float latitude)
{
  float s = abs(phi.y);
  vec2 t;
  if (s < WFV_POLAR_SIDE)
  {
    float a = wfvMollweideFromEquator(s);
    vec2 at = wfvSinCos(a);
    t = vec2(at.y, at.x);
  }
  else
  {
    float a = wfvMollweideFromPole(wfvPolarGap(phi));
    t = wfvSinCos(a);
  }
  return vec2(WFV_MOLLWEIDE_WIDTH * t.x, phi.y < 0.0 ? -WFV_TOP * t.y : WFV_TOP * t.y);
}

WFV_FN vec3 wfvAtHeight(float y)
{
  float s = min(1.0, abs(y) / WFV_TOP);
  float c = sqrt((1.0 - s) * (1.0 + s));
  float t = wfvAtan2(s, c);
  float w = 2.0 * wfvAtan2(c, s);
  float sine = (2.0 * t + wfvSinCos(2.0 * t).x) / WFV_PI;
  vec2 phi = sine < WFV_POLAR_SIDE ? vec2(sqrt((1.0 - sine) * (1.0 + sine)), sine)
                                   : wfvFromPolarGap(wfvArcMinusSine(w) / WFV_PI);
  return vec3(WFV_MOLLWEIDE_WIDTH * c, phi.x, y < 0.0 ? -phi.y : phi.y);
}
