// SPDX-License-Identifier: BSD-3-Clause
// Geometry stage of spheres, cylinders, tubes and splats: rectangles that surely contain the
// picture. What is looked for lies in a round cap of directions; how a cap is covered is up to the family
// (cap_*.glsl). The fragment stage decides by the ray of each pixel.
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
