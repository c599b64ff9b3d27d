// SPDX-License-Identifier: BSD-3-Clause
// Stereo all round: two eyes that turn with every column of the picture, on a circle whose
// diameter is the interpupillary distance. The ray of the direction (lambda, phi) starts at the
// tangent point r (cos lambda, 0, sin lambda), where r is how far the eye is to the right: half that
// distance, below 0 for the left one. So a point at the horizontal distance d is seen at the
// longitude lambda - asin(r / d) and at the latitude atan2(Y, sqrt(d^2 - r^2)). Source: Peleg,
// Ben-Ezra and Pritch 2001 (the circle); the closed form of the point is geometry.
//
// The circle is level in view coordinates, whatever the tilt. Points nearer to its axis than r
// are seen by no ray: they count as on the circle (defined, not seen). Above and below, both eyes
// look at the circle from its rim, and turn about; with a fade r shrinks smoothly (C1) to nothing
// between two latitudes of the ray, which must be solved for: see wfvSeenLatitude. WFV_FADES is
// false in a shader of a view without a fade.
//
// v.halfEyes: radius of the circle, scene units
// v.stereo:   x, y  latitudes between which it fades, radians; equal: no fade

// True where the circle is smaller for some latitudes.
WFV_FN bool wfvFades(WfvView v)
{
  return WFV_FADES && v.stereo.y > v.stereo.x;
}

// Where on the way of the fade a latitude is, 0 to 1.
WFV_FN float wfvFadeAt(float latitude, WfvView v)
{
  float t = (abs(latitude) - v.stereo.x) / (v.stereo.y - v.stereo.x);
  return v.stereo.y > v.stereo.x ? max(0.0, min(1.0, t)) : 0.0;
}

// How far the eye is to the right for rays of this latitude.
WFV_FN float wfvRadiusAt(float latitude, WfvView v)
{
  float t = wfvFadeAt(latitude, v);
  return wfvToRight(v) * (1.0 - t * t * (3.0 - 2.0 * t));
}

WFV_FN vec3 wfvEyeAt(vec3 direction, WfvView v)
{
  vec3 up = wfvUpright(v);
  vec3 side = cross(direction, up);
  float l = length(side); // of at most 1: no square of it is too large
  float r = wfvToRight(v);
  if (wfvFades(v))
  {
    r = wfvRadiusAt(wfvAtan2(dot(direction, up), l), v);
  }
  return l > 0.0 ? side * (r / l) : vec3(0.0, 0.0, 0.0);
}

// Length of the tangent from a point at the distance d to the circle of radius r.
WFV_FN float wfvTangent(float d, float r)
{
  return sqrt(max(0.0, (d - r) * (d + r)));
}

// Latitude at which a point is seen whose height is y >= 0 and horizontal distance d, with the
// fade: the zero of phi - atan2(y, sqrt(d^2 - r(phi)^2)), which grows with phi everywhere.
// Newton's method, kept inside a bracket: between the latitudes without and with all of r.
WFV_FN float wfvSeenLatitude(float d, float y, WfvView v)
{
  float low = wfvAtan2(y, d);
  float high = wfvAtan2(y, wfvTangent(d, wfvToRight(v)));
  float phi = low;
  for (int i = 0; i < WFV_NEWTON_STEPS; i++)
  {
    float t = wfvFadeAt(phi, v);
    float r = wfvRadiusAt(phi, v);
    float q = wfvTangent(d, r);
    float e = phi - wfvAtan2(y, q);
    low = e > 0.0 ? low : phi;
    high = e > 0.0 ? phi : high;
    float shrink = 6.0 * t * (1.0 - t) * wfvToRight(v) / max(v.stereo.y - v.stereo.x, 1e-9);
    float slope = 1.0 + y * r * shrink / max(q * (y * y + q * q), 1e-30);
    float next = phi - e / slope;
    phi = next > low && next < high ? next : 0.5 * (low + high);
  }
  return phi;
}

WFV_FN WfvRayHit wfvSee(vec3 p, WfvView v)
{
  vec3 up = wfvUpright(v);
  float y = dot(p, up);
  vec3 flat_ = p - up * y;
  float d = wfvHypot(wfvHypot(flat_.x, flat_.y), flat_.z);
  float r = wfvToRight(v);
  if (wfvFades(v))
  {
    r = wfvRadiusAt(wfvSeenLatitude(d, abs(y), v), v);
  }
  WfvRayHit s;
  s.seen = d > abs(r);
  float limit = s.seen ? d : abs(r);
  float q = wfvTangent(d, r);
  vec3 ahead = d > 0.0 ? flat_ / d : vec3(0.0, v.tilt.y, v.tilt.x) * -1.0;
  vec3 side = cross(ahead, up);
  vec3 u = limit > 0.0 ? ahead * (q / limit) - side * (r / limit) : ahead;
  s.distance = wfvHypot(q, y);
  s.direction = s.distance > 0.0 ? (u * q + up * y) / s.distance : u;
  s.seen = s.seen && s.distance > 0.0;
  return s;
}

// The same, without a fade, of a point whose horizontal distance to the circle is known better than its place
// tells: level is the point without its height y, up the vertical.
WFV_FN WfvRayHit wfvSeeAt(vec3 level, float y, float way, vec3 up, float r)
{
  float squared = way * way + r * r;
  vec3 ahead = squared > 0.0 ? (level * way - cross(level, up) * r) / squared : level;
  WfvRayHit s;
  s.distance = wfvHypot(way, y);
  s.direction = s.distance > 0.0 ? (ahead * way + up * y) / s.distance : ahead;
  s.seen = s.distance > 0.0;
  return s;
}

WFV_FN vec2 wfvShift(vec2 ndc, float depth, WfvView v)
{
  return ndc;
}

WFV_FN vec2 wfvUnshift(vec2 ndc, float depth, WfvView v)
{
  return ndc;
}
