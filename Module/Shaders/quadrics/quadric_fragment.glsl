// SPDX-License-Identifier: BSD-3-Clause
// Fragment side of spheres, cylinders and tubes: the surface met by the ray of this pixel,
// its coverage, depth and normal, before the stock shader runs. The surface is drawn as
// a mesh of it would be: the first crossing between the clip spheres, from its inside too.

#if !WFV_NON_CENTRAL_IMPOSTORS
#define wfvSphereSeen wfvSphere
#define wfvOtherSeen wfvOther
#endif

void wfvInterpolate(); // generated: sets the stock shader's inputs from wfvAlong

// A line through a convex surface: where it enters and where it leaves.
struct WfvCrossing
{
  bool met;
  vec2 distance; // along the ray, the stage's own units
  vec2 along;    // on its length, 0 to 1
  vec3 entry;    // normals, outwards
  vec3 exit;
};

// One of the two crossings.
struct WfvSeen
{
  bool seen;
  bool front;
  float distance;
  float along;
  vec3 normal; // outwards
};

// A sphere met by the line along the unit vector u. The centre's distance from the line
// comes from a cross product and every difference of squares as a product: nothing
// cancels for spheres that are small, far away, or near the eye.
WfvCrossing wfvMeetSphere(vec3 u, vec3 c, float r)
{
  vec3 w = cross(c, u);
  float q = length(w);
  float s = sqrt(max((r - q) * (r + q), 0.0));
  float b = dot(c, u);
  float d = length(c);
  float product = (d - r) * (d + r); // of the two distances
  float large = b < 0.0 ? b - s : b + s;
  float small = large != 0.0 ? product / large : 0.0;
  vec3 aside = cross(w, u); // from the centre to the nearest point of the line
  WfvCrossing x;
  x.met = q <= r;
  x.distance = b < 0.0 ? vec2(large, small) : vec2(small, large);
  x.along = vec2(0.0);
  x.entry = (aside - s * u) / r;
  x.exit = (aside + s * u) / r;
  return x;
}

WfvCrossing wfvMeet(vec3 u); // of each kind

bool wfvBetweenClips(float rho)
{
  return rho >= wfvView.radii.x / wfvScale() && rho <= wfvView.radii.y / wfvScale();
}

bool wfvOwns(float along)
{
  return along >= wfvShare.x && (along < wfvShare.y || wfvShare.y >= 1.0);
}

// side: 1 its front only, -1 its back only, 0 whichever comes first
WfvSeen wfvLook(vec3 u, int side)
{
#if WFV_NON_CENTRAL_IMPOSTORS
  wfvStandAt(wfvEyeAt(u, wfvView) / wfvScale());
#endif
  WfvCrossing x = wfvMeet(u);
  bool front = side >= 0 && wfvBetweenClips(x.distance.x);
  bool back = side <= 0 && !front && wfvBetweenClips(x.distance.y);
  WfvSeen s;
  s.front = front;
  s.distance = front ? x.distance.x : x.distance.y;
  s.along = front ? x.along.x : x.along.y;
  s.normal = front ? x.entry : x.exit;
  s.seen = x.met && (front || back) && wfvOwns(s.along);
  return s;
}

// What the pixel's centre sees or, where that sees nothing, the first sample that does;
// the sample mask is that of the samples.
WfvSeen wfvLookAround(int side, out vec3 direction)
{
  WfvRay ray = wfvRayAt(vec2(0.0));
  WfvSeen here = wfvLook(ray.direction, side);
  here.seen = here.seen && ray.inside;
  direction = ray.direction;
  if (wfvSamples <= 1)
  {
    return here;
  }
  int mask = 0;
  for (int i = 0; i < wfvSamples; i++)
  {
    ray = wfvRayAt(wfvSampleOffsets[i]);
    WfvSeen s = wfvLook(ray.direction, side);
    if (s.seen && ray.inside)
    {
      mask |= 1 << i;
      direction = here.seen ? direction : ray.direction;
      here = here.seen ? here : s;
    }
  }
#ifdef GL_ARB_sample_shading
  gl_SampleMask[0] = mask;
#endif
  here.seen = mask != 0;
  return here;
}

float wfvWindowDepth(float rho)
{
  return wfvDepthOf(rho * wfvScale(), wfvView);
}

void wfvPrepare(int side)
{
#ifdef GL_ARB_sample_shading
  gl_SampleMask[0] = -1;
#endif
  vec3 direction;
  WfvSeen s = wfvLookAround(side, direction);
  wfvHide = !s.seen;
  wfvFront = s.front;
  wfvDepth = clamp(wfvWindowDepth(s.distance), 0.0, 1.0);
  wfvAlong = clamp(s.along, 0.0, 1.0);
  wfvSurface = wfvUntilt(direction, wfvView) * (s.distance * wfvScale());
#if WFV_NON_CENTRAL_IMPOSTORS
  wfvHitDirection = wfvUntilt(direction, wfvView);
  wfvDistanceSeen = s.distance * wfvScale();
  wfvSurface += wfvUntilt(wfvEyeAt(direction, wfvView), wfvView);
#endif
  wfvNormal = normalize(wfvUntilt(s.front ? s.normal : -s.normal, wfvView));
  wfvInterpolate();
}
