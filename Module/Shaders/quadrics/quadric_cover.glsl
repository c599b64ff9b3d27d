// SPDX-License-Identifier: BSD-3-Clause
// Geometry stage of spheres, cylinders, tubes and splats: rectangles that surely contain the
// picture. What is looked for lies in a round cap of directions; a cap becomes a
// rectangle of angles, and that a rectangle of the map (wfvBounds), in two parts where it
// reaches across the seam. The fragment stage decides by the ray of each pixel.
//
// Positions are in tilted view coordinates, divided by a power of two near the far radius.

flat out vec4 wfvSphere;  // centre and radius; tubes: those of the first end
flat out vec4 wfvOther; // tubes: the second end; cylinders: axis and half length
flat out vec2 wfvShare; // the part of the length, of 0 to 1, that this rectangle draws

vec4 wfvSphereHere = vec4(0.0);
vec4 wfvOtherHere = vec4(0.0);
vec2 wfvShareHere = vec2(0.0);

// Pixels added round a covering shape, for the rounding of its own bounds.
const float WFV_PAD = 1.5;

// Angle added round a cap, radians: float32 rounding of angles.
const float WFV_CAP_PAD = 2e-6;

// Relative slack of a cap's extent in azimuth, whose arc sine is steep at its end.
const float WFV_CAP_SLACK = 1e-5;

#if WFV_NON_CENTRAL_IMPOSTORS
// Radius of the circle on which the rays begin, the stage's own units, rounded up.
float wfvBaselineRadius()
{
  return 1.0001 * wfvFromMiddle(wfvView) / wfvScale();
}

// Radians: how far from where the origin sees a point an eye on the circle may see it, whose
// distance from the origin is at least so much; half a turn for what is as near as the circle.
float wfvGrowOf(float nearest)
{
  float s = wfvBaselineRadius() / max(nearest, 1e-30);
  return nearest > 0.0 && s < 1.0 ? wfvAtan2(s, sqrt((1.0 - s) * (1.0 + s))) : WFV_PI;
}
#else
float wfvBaselineRadius()
{
  return 0.0;
}

float wfvGrowOf(float nearest)
{
  return 0.0;
}
#endif

void wfvEmitCorner(vec2 ndc)
{
  gl_Position = vec4(ndc * wfvTile.xy + wfvTile.zw, 0.0, 1.0);
  wfvSphere = wfvSphereHere;
  wfvOther = wfvOtherHere;
  wfvShare = wfvShareHere;
  wfvWriteCorners();
  gl_PrimitiveID = gl_PrimitiveIDIn;
  EmitVertex();
}

// A rectangle in the NDC of the picture, seen from its front or its back.
void wfvEmitBox(vec4 r, bool front)
{
  vec2 pad = 2.0 * WFV_PAD / (wfvViewport.zw * wfvTile.xy);
  r = vec4(max(r.xy - pad, -1.0 - wfvView.center), min(r.zw + pad, 1.0 - wfvView.center));
  if (r.x >= r.z || r.y >= r.w)
  {
    return;
  }
  wfvEmitCorner(front ? r.xy : r.xw);
  wfvEmitCorner(front ? r.zy : r.zw);
  wfvEmitCorner(front ? r.xw : r.xy);
  wfvEmitCorner(front ? r.zw : r.zy);
  EndPrimitive();
}

void wfvEmitWindow(bool front)
{
  wfvEmitBox(vec4(-1.0 - wfvView.center, 1.0 - wfvView.center), front);
}

#if WFV_ANGULAR
// A rectangle of angles whose azimuth may extend across the seam.
void wfvEmitAngles(vec4 a, bool front)
{
#if WFV_MERIDIAN
  float turn = 2.0 * WFV_PI;
  wfvEmitBox(wfvBounds(vec4(max(a.x, -WFV_PI), a.y, min(a.z, WFV_PI), a.w), wfvView), front);
  if (a.z > WFV_PI)
  {
    wfvEmitBox(wfvBounds(vec4(-WFV_PI, a.y, a.z - turn, a.w), wfvView), front);
  }
  else if (a.x < -WFV_PI)
  {
    wfvEmitBox(wfvBounds(vec4(a.x + turn, a.y, WFV_PI, a.w), wfvView), front);
  }
#else
  wfvEmitBox(wfvBounds(a, wfvView), front);
#endif
}

// Sine of the angle between a direction and the poles of the family.
float wfvPoleSine(vec3 p)
{
#if WFV_MERIDIAN
  return wfvHypot(p.x, p.z) / wfvLength(p);
#else
  return wfvHypot(p.x, p.y) / wfvLength(p);
#endif
}

// The range of the polar angle (latitude, or theta) of the whole family.
vec2 wfvPolarRange()
{
#if WFV_MERIDIAN
  return vec2(-0.5 * WFV_PI, 0.5 * WFV_PI);
#else
  return vec2(0.0, WFV_PI);
#endif
}

void wfvCoverCap(vec3 centre, float angle, bool front)
{
  float radius = angle + WFV_CAP_PAD;
  if (!(radius < 0.5 * WFV_PI) || !(wfvLength(centre) > 0.0))
  {
    wfvEmitWindow(front);
    return;
  }
  vec2 a = WFV_ANGLES(centre);
  vec2 all = wfvPolarRange();
  float low = a.y - radius;
  float high = a.y + radius;
  // where the cap holds a pole it has every azimuth; else its edge meets the farthest
  // meridian at a right angle
  float s = (1.0 + WFV_CAP_SLACK) * sin(radius) / max(wfvPoleSine(centre), 1e-30);
  bool pole = low <= all.x || high >= all.y || s >= 1.0;
  float across = pole ? WFV_PI : wfvAtan2(s, sqrt((1.0 - s) * (1.0 + s))) + WFV_CAP_PAD;
#if WFV_MERIDIAN
  a.x = pole ? 0.0 : a.x;
#else
  all.y = min(all.y, wfvView.maxAngle);
#endif
  low = max(low, all.x);
  high = min(high, all.y);
  if (low <= high)
  {
    wfvEmitAngles(vec4(a.x - across, low, a.x + across, high), front);
  }
}
#elif WFV_SAMPLED
void wfvCoverCap(vec3 centre, float angle, bool front)
{
  float l = wfvLength(centre);
  if (l > 0.0)
  {
    WfvPlaces places = wfvCapPlaces(centre / l, angle + WFV_CAP_PAD, wfvView);
    bool both = places.second.x <= places.second.z;
    wfvEmitBox(both ? wfvUnited(places.first, places.second) : places.first, front);
    return;
  }
  wfvEmitWindow(front);
}
#else
// A map that says nothing of angles: the whole window is sure.
void wfvCoverCap(vec3 centre, float angle, bool front)
{
  wfvEmitWindow(front);
}
#endif

// Angular radius of the cap that holds a sphere seen from the eye; half a turn from inside.
float wfvSphereAngle(vec4 sphere)
{
  float d = wfvLength(sphere.xyz);
  float angle = d > sphere.w ? wfvAtan2(sphere.w, sqrt((d - sphere.w) * (d + sphere.w))) : WFV_PI;
  return angle + wfvGrowOf(d - sphere.w);
}

// Surely nothing to see: wholly inside the near or outside the far sphere, or no number.
bool wfvSphereCulled(vec4 sphere)
{
  float d = wfvLength(sphere.xyz);
  return !(sphere.w > 0.0) || !(d + sphere.w >= wfvView.radii.x / wfvScale()) ||
    !(d - sphere.w - wfvBaselineRadius() <= wfvView.radii.y / wfvScale());
}
