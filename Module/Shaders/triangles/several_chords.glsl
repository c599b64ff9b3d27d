// SPDX-License-Identifier: BSD-3-Clause
// Fragment side of the pre-clip: edges that several chords stand for.

flat in vec3 wfvCount; // out_counts.glsl
flat in vec3 wfvPlace0;
flat in vec3 wfvPlace1;
flat in vec3 wfvPlace2;

// In the picture, from the tile's centre, pixels.
vec2 wfvInPicture(vec3 p)
{
#if WFV_NON_CENTRAL
  p = wfvSeenPlace(p);
#endif
  vec4 c = wfvClip(wfvProject(p, wfvView), wfvLength(p) * wfvScale());
  return 0.5 * wfvViewport.zw * c.xy / c.w;
}

// The chord of an edge of several, from p to q, that is at the way which a ray looks beside: its ends.
// n: the plane of the edge and the eye.
vec4 wfvChordAt(vec3 p, vec3 q, vec3 n, float chords, vec3 direction)
{
  vec3 first_ = p;
  vec3 last_ = q;
#if WFV_NON_CENTRAL
  first_ -= wfvStart(direction);
  last_ -= wfvStart(direction);
  n = cross(first_, last_);
#endif
  float fromP = dot(cross(first_, direction), n);
  float fromQ = dot(cross(direction, last_), n);
  float share = fromP / (fromP + fromQ);
  float at = clamp(floor(share * chords), 0.0, chords - 1.0);
  float first = at / chords;
  float second = (at + 1.0) / chords;
  return vec4(wfvInPicture((1.0 - first) * p + first * q), wfvInPicture((1.0 - second) * p + second * q));
}
