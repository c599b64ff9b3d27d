// SPDX-License-Identifier: BSD-3-Clause
// Winkel tripel: the mean of Aitoff's map and the equirectangular one with the standard
// parallel acos(2/pi), so that x = (2 lambda / pi + x of Aitoff) / 2 and
// y = (phi + y of Aitoff) / 2. Source: Snyder, Flattening the Earth (1993), p. 231.
// The inverse has no closed form: Newton in (lambda, phi); the Jacobian after Ipbueker and
// Bildirici (2002), its determinant vanishes nowhere on the closed domain.
// Raw map: x in [-(1 + pi/2), 1 + pi/2], y in [-pi/2, pi/2]. Domain: the sphere.
// Discontinuities: the meridian lambda = +-pi, the curved border; both poles are lines.

// From (cosine, sine) of half the longitude and of the latitude, and these angles.
WFV_FN vec2 wfvWinkel(vec2 halfLambda, vec2 phi, vec2 angles)
{
  float x = phi.x * halfLambda.y;
  float s = wfvHypot(x, phi.y);
  float k = s > 0.0 ? wfvAtan2(s, phi.x * halfLambda.x) / s : 1.0;
  return vec2(2.0 / WFV_PI * angles.x + x * k, 0.5 * (angles.y + phi.y * k));
}

WFV_FN vec2 wfvFlat(vec2 halfLambda, vec2 phi)
{
  return wfvWinkel(
    halfLambda, phi, vec2(wfvAtan2(halfLambda.y, halfLambda.x), wfvAtan2(phi.y, phi.x)));
}

// Latitude at which the border, lambda = pi, has this y in [0, pi/2]: y is concave there
// and starts above the root, so Newton's steps end in it from below.
WFV_FN float wfvWinkelBorder(float y)
{
  float phi = y;
  for (int i = 0; i < WFV_NEWTON_STEPS; i++)
  {
    vec2 at = wfvSinCos(phi);
    float step_ = (phi + 0.5 * WFV_PI * at.x - 2.0 * y) / (1.0 + 0.5 * WFV_PI * at.y);
    phi = max(0.0, min(0.5 * WFV_PI, phi - step_));
    if (abs(step_) <= WFV_ROOT_STEP)
    {
      break;
    }
  }
  return phi;
}

// One step of Newton's method at (lambda/2, phi) towards the point m of the raw map.
WFV_FN vec2 wfvWinkelStep(vec2 a, vec2 m)
{
  vec2 atL = wfvSinCos(a.x);
  vec2 atP = wfvSinCos(a.y);
  vec2 l = vec2(atL.y, atL.x);
  vec2 p = vec2(atP.y, atP.x);
  float c = p.x * l.x;
  float s = wfvHypot(p.x * l.y, p.y);
  float k = s > 0.0 ? wfvAtan2(s, c) / s : 1.0;
  // the derivative of k over that of -cos(a): 1/3 in the centre, where it cancels
  float d = s > 0.01 ? (1.0 - k * c) / (s * s) : 1.0 / 3.0;
  float xl = 2.0 / WFV_PI + p.x * (l.x * k + d * p.x * l.y * l.y);
  float xp = l.y * p.y * (d * c - k);
  float yl = 0.5 * p.y * d * p.x * l.y;
  float yp = 0.5 * (1.0 + p.x * k + d * p.y * p.y * l.x);
  vec2 e = wfvWinkel(l, p, a);
  e = vec2(e.x - m.x, e.y - m.y);
  float det = xl * yp - xp * yl;
  return vec2((yp * e.x - xp * e.y) / det, (xl * e.y - yl * e.x) / det);
}

WFV_FN WfvRay wfvRayOfMap(vec2 m, WfvView v)
{
  float rim = 0.5 * WFV_PI;
  float y = min(rim, abs(m.y));
  float border = wfvWinkelBorder(y);
  float width = 1.0 + 0.5 * WFV_PI * max(0.0, wfvSinCos(border).y);
  WfvRay ray;
  ray.inside = abs(m.y) <= rim * WFV_BORDER && abs(m.x) <= width * WFV_BORDER;
  float x = min(width, abs(m.x));
  // between the central meridian, where phi = y, and the border
  float t = x / width;
  vec2 a = vec2(rim * t, y + (border - y) * t * t);
  for (int i = 0; i < WFV_NEWTON_STEPS; i++)
  {
    vec2 step_ = wfvWinkelStep(a, vec2(x, y));
    a = vec2(max(0.0, min(rim, a.x - step_.x)), max(0.0, min(rim, a.y - step_.y)));
    if (abs(step_.x) + abs(step_.y) <= WFV_ROOT_STEP)
    {
      break;
    }
  }
  ray.direction = wfvOnItsSide(
    wfvMeridianDirection(vec2(m.x < 0.0 ? -2.0 * a.x : 2.0 * a.x, m.y < 0.0 ? -a.y : a.y)), m.x);
  return ray;
}
