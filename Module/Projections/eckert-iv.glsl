// SPDX-License-Identifier: BSD-3-Clause
// Eckert IV: equal-area, the borders half ellipses, the poles lines half as long as the
// equator. With t + sin(t) cos(t) + 2 sin(t) = (2 + pi/2) sin(phi):
// x = 2 / sqrt(pi (4 + pi)) lambda (1 + cos(t)), y = 2 sqrt(pi / (4 + pi)) sin(t).
// Source: Snyder, Map Projections: A Working Manual (1987), chapter 32.
// Domain: the sphere. Discontinuities: the meridian lambda = +-pi, the curved border; both
// poles stretch to the top and bottom borders, where the map is flat.

const float WFV_TOP = 1.3265004281770023;            // 2 sqrt(pi / (4 + pi))
const float WFV_ECKERT_WIDTH = 0.42223820031577125;  // 2 / sqrt(pi (4 + pi))
const float WFV_ECKERT = 3.5707963267948966;         // 2 + pi/2

WFV_FN float wfvEckertFromEquator(float s)
{
  float k = WFV_ECKERT * s;
  float t = 0.25 * k;
  for (int i = 0; i < WFV_NEWTON_STEPS; i++)
  {
    vec2 at = wfvSinCos(t);
    float step_ = (t + at.x * (at.y + 2.0) - k) / (2.0 * at.y * (at.y + 1.0));
    t = max(0.0, min(1.5, t - step_));
    if (abs(step_) <= WFV_ROOT_STEP)
    {
      break;
    }
  }
  return t;
}

// u = pi/2 - t from the pole: u - sin(u) cos(u) + 2 (1 - cos(u)) = (2 + pi/2) gap. The
// left side begins with u^2.
WFV_FN float wfvEckertFromPole(float gap)
{
  float k = WFV_ECKERT * gap;
  float u = sqrt(k);
  for (int i = 0; i < WFV_NEWTON_STEPS && u > 0.0; i++)
  {
    float s = wfvSinCos(u).x;
    float half_ = wfvSinCos(0.5 * u).x;
    float e = 0.5 * wfvArcMinusSine(2.0 * u) + 4.0 * half_ * half_ - k;
    float step_ = e / (2.0 * s * (s + 1.0));
    u = max(0.0, min(1.5, u - step_));
    if (abs(step_) <= WFV_ROOT_STEP * u)
    {
      break;
    }
  }
  return u;
}

WFV_FN vec2 wfvParallel(vec2 phi, float latitude)
{
  float s = abs(phi.y);
  vec2 t;
  if (s < WFV_POLAR_SIDE)
  {
    float a = wfvEckertFromEquator(s);
    vec2 at = wfvSinCos(a);
    t = vec2(at.y, at.x);
  }
  else
  {
    float a = wfvEckertFromPole(wfvPolarGap(phi));
    t = wfvSinCos(a);
  }
  return vec2(WFV_ECKERT_WIDTH * (1.0 + t.x), phi.y < 0.0 ? -WFV_TOP * t.y : WFV_TOP * t.y);
}

WFV_FN vec3 wfvAtHeight(float y)
{
  float s = min(1.0, abs(y) / WFV_TOP);
  float c = sqrt((1.0 - s) * (1.0 + s));
  float t = wfvAtan2(s, c);
  float u = wfvAtan2(c, s);
  float sine = (t + s * (c + 2.0)) / WFV_ECKERT;
  float half_ = wfvSinCos(0.5 * u).x;
  float gap = (0.5 * wfvArcMinusSine(2.0 * u) + 4.0 * half_ * half_) / WFV_ECKERT;
  vec2 phi = sine < WFV_POLAR_SIDE ? vec2(sqrt((1.0 - sine) * (1.0 + sine)), sine)
                                   : wfvFromPolarGap(gap);
  return vec3(WFV_ECKERT_WIDTH * (1.0 + c), phi.x, y < 0.0 ? -phi.y : phi.y);
}
