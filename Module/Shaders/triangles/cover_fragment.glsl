// SPDX-License-Identifier: BSD-3-Clause
// Fragment side of the pre-clip: barycentric coordinates, coverage and depth of the
// primitive at this pixel, before the stock shader runs.

// Rays and edges in double, so that what is thinner than float32 turns a ray is decided too.
#ifdef GL_ARB_gpu_shader_fp64
#define WFV_DOUBLES WFV_WHOLE
#else
#define WFV_DOUBLES 0
#endif
#if WFV_DOUBLES
#define WFV_EDGE dvec3
#define WFV_SIDE double
#else
#define WFV_EDGE vec3
#define WFV_SIDE float
#endif
flat in WFV_EDGE wfvEdge0;
flat in WFV_EDGE wfvEdge1;
flat in WFV_EDGE wfvEdge2;
flat in vec3 wfvPlane;
#if WFV_OWN_RAYS || WFV_CURVED_RAYS
flat in vec3 wfvAnchor;
#elif WFV_DOUBLES
flat in double wfvOfPoints;
#else
flat in vec3 wfvToward;
flat in vec2 wfvMeets;
#endif
#if WFV_OWN_RAYS
flat in vec3 wfvSpan0;
flat in vec3 wfvSpan1;
flat in vec3 wfvSpan2;
float wfvTurn = 0.0; // of the ray asked for last: -1 where it sees the other side than the origin
float wfvFacing = 1.0; // that of the pixel's centre
#else
const float wfvFacing = 1.0;
#endif
#if !WFV_EXACT
in vec3 wfvBary;
in vec3 wfvPosition;
flat in vec3 wfvSlack;
#endif
#if !WFV_EXACT || WFV_DEBUG_VIEW
flat in int wfvMode;
#endif

vec3 wfvB = vec3(0.0); // barycentric coordinates here
float wfvRho = 0.0; // distance from the eye here, in the stage's own units
float wfvDepth = 0.0; // window depth here, 0 to 1
bool wfvHide = false; // not covered: discarded once the stock shader has run
bool wfvFront = false; // seen from its front

#if WFV_EDGES
vec3 wfvEdgePixels = vec3(0.0); // distance in pixels to the edge opposite to corner 0, 1, 2
vec3 wfvEdgeDistances(); // edge_distance.glsl
#endif

void wfvInterpolate(); // generated: sets the stock shader's inputs from wfvB

vec2 wfvSample = vec2(0.0); // looked at, pixels from the centre

// order_fragment.glsl
void wfvOrder(float approach, vec3 e);

// chord_fragment.glsl
vec3 wfvChordReach();
vec3 wfvToChords(vec3 direction, vec3 e, vec3 dx, vec3 dy);
bool wfvAllInside(vec3 e, vec3 toChords);

#if WFV_CURVED_RAYS
WfvRay wfvSurfaceRay(vec2 offset); // curved_fragment.glsl
#else
// The ray of the map that this pixel sees the surface by.
WfvRay wfvSurfaceRay(vec2 offset)
{
  return wfvRayAt(offset);
}
#endif

#if WFV_OWN_RAYS
// Where the ray of a direction begins, the stage's own units.
vec3 wfvStart(vec3 direction)
{
  return wfvEyeAt(direction, wfvView) * (1.0 / wfvScale()); // a power of two
}

// Times the triangle's normal, how far its plane is ahead of such a place; below 0 for one that
// sees it from the side that the origin does not.
float wfvAhead(vec3 start)
{
  return dot(wfvPlane, wfvAnchor - start);
}
#endif

// Positive inside.
WFV_EDGE wfvEdgesAt(WFV_EDGE direction)
{
  WFV_EDGE e = WFV_EDGE(dot(direction, wfvEdge0), dot(direction, wfvEdge1), dot(direction, wfvEdge2));
#if WFV_OWN_RAYS
  // a ray's moment, times the edge, is what it changes to begin elsewhere than in the origin
  vec3 start = wfvStart(direction);
  vec3 moment = cross(start, direction);
  e += vec3(dot(moment, wfvSpan0), dot(moment, wfvSpan1), dot(moment, wfvSpan2));
  wfvTurn = wfvAhead(start) < 0.0 ? -1.0 : 1.0;
  e *= wfvTurn;
#endif
  return e;
}

#if WFV_DOUBLES
// What wfvPixelToMap has too few digits for.
uniform vec2 wfvPixelToMapLow;

// The ray of the pixel's centre in double.
WfvWholeRay wfvWholeRayAt()
{
  WfvWholeView v;
  v.scale = dvec2(wfvView.scale);
  v.lens = dvec4(wfvView.lens);
  v.lens5 = double(wfvView.lens5);
  v.lensHigh = dvec4(wfvView.lensHigh);
  v.maxAngle = double(wfvView.maxAngle);
#if WFV_SAMPLED
  v.tables = dvec4(wfvView.tables);
#endif
  dvec2 perPixel = dvec2(wfvPixelToMap.zw) + dvec2(wfvPixelToMapLow);
  return wfvWholeRayOfMap(dvec2(gl_FragCoord.xy - wfvPixelToMap.xy) * perPixel, v);
}
#endif

// How they change over a step of the direction.
vec3 wfvEdgeStep(vec3 direction, vec3 step_)
{
#if WFV_OWN_RAYS
  return wfvEdgesAt(direction + step_) - wfvEdgesAt(direction);
#else
  return vec3(wfvEdgesAt(WFV_EDGE(step_)));
#endif
}

// Barycentric coordinates from the edge functions. Where a triangle is seen edge-on they
// are rounding alone, and may sum up to nothing.
vec3 wfvWeigh(vec3 e)
{
  float sum = e.x + e.y + e.z;
  return sum > 0.0 ? e * (1.0 / sum) : vec3(1.0 / 3.0);
}

// Of the triangle's own plane, towards the eye, view coordinates. Differences between
// pixels, which stock VTK and the data pass take, are no numbers where a pixel of the quad
// lies outside the map.
#define WFV_FLAT_NORMAL
vec3 wfvFlatNormal()
{
  vec3 n = wfvUntilt(-wfvFacing * wfvPlane, wfvView);
  return n / wfvLength(n);
}

// Pixels: no sample is farther from its pixel's centre along either axis.
const float WFV_SAMPLE_REACH = 0.5;

// Safety over first-order bounds of what changes inside a pixel.
const float WFV_PIXEL_SAFETY = 1.5;

// By the plane; interpolated depth would err along edges that run away from the eye, and
// the position that corners are weighed to, beside the eye, where they are far.
void wfvSetDistance(float rho)
{
  wfvRho = rho;
  wfvDepth = wfvDepthInUnits(rho);
}

#if WFV_OWN_RAYS || WFV_CURVED_RAYS
// The plane times a direction: above 0 for one that goes towards it.
float wfvApproach(vec3 direction)
{
  return dot(direction, wfvPlane);
}

// Distance at which a ray meets the plane, from the anchor on: what is rounded then is a share
// of the way from there, not of the whole distance.
float wfvMeet(vec3 direction, float approach)
{
#if WFV_OWN_RAYS
  vec3 anchor = wfvAnchor - wfvStart(direction);
#else
  vec3 anchor = wfvAnchor;
#endif
  float along = dot(direction, anchor);
  return along + dot(wfvPlane, anchor - along * direction) / approach;
}
#else
// The same, from the known direction on: of a surface seen nearly edge-on the terms of a product
// with the whole direction would cancel, and what they are rounded by would decide its distance.
#if WFV_DOUBLES
double wfvOfPlane = 0.0lf; // the edges' planes add up to the triangle's

float wfvApproach(vec3 direction)
{
  return float(wfvOfPlane);
}

double wfvWholeDistance()
{
  return wfvOfPoints / wfvOfPlane;
}

// Distance at which a ray meets the plane.
float wfvMeet(vec3 direction, float approach)
{
  return float(wfvWholeDistance());
}
#else
float wfvApproach(vec3 direction)
{
  return wfvMeets.x + dot(wfvPlane, direction - wfvToward);
}

float wfvMeet(vec3 direction, float approach)
{
  return wfvMeets.y / approach;
}
#endif
#endif

#if WFV_EXACT
// The point itself and the direction from the eye to it, view coordinates.
vec3 wfvSurface = vec3(0.0);
vec3 wfvSight = vec3(0.0);
#define WFV_FROM_EYE wfvSight

void wfvSetSurface(vec3 direction)
{
  wfvSight = wfvUntilt(direction, wfvView);
  wfvSurface = wfvSight * (wfvRho * wfvScale());
#if WFV_OWN_RAYS
  wfvSurface += wfvUntilt(wfvEyeAt(direction, wfvView), wfvView);
#endif
}
#endif

// Window depth, two steps of a buffer of 24 bits, for each face may be rounded by one: by so much is
// what is seen from behind put back. Where a surface folds away from the eye a pixel's ray may lie so
// near the fold that its front and its back come out at one depth; then the front shows, in whichever
// order they come.
const float WFV_BEHIND = 2.0 / 16777216.0;

// For the data pass.
#define WFV_DISTANCE (wfvRho * wfvScale())

// Software rendering runs through both sides of every branch and through each loop once, so
// what a draw cannot need is left out of its shader: samples and chords.
#if WFV_EXACT
const bool wfvByChord = false;
#else
bool wfvByChord = false; // drawn with chords: a chord decides which pixels are covered
#endif

#if WFV_OWN_RAYS
// Share of the angle to the axis of the circle: rays that turn about it by more from pixel to
// pixel say nothing of what is between them.
const float WFV_TURNING = 0.1;

// True where the places at which rays begin turn about within this pixel.
bool wfvTurns(vec3 direction)
{
  vec3 x = dFdx(direction);
  vec3 y = dFdy(direction);
  float axis = wfvLength(cross(direction, wfvUpright(wfvView)));
  return !(length(x) + length(y) < WFV_TURNING * axis);
}
#endif

#if WFV_MULTISAMPLE
// By which ray the fragment has its depth and its attributes: the centre's, or that of a sample
// where the centre is not covered. A face seen nearly edge-on, continued to there, would come out
// before the one that hides it.
vec3 wfvShown = vec3(0.0);

// Coverage by the ray of each sample, or by that of the pixel's centre where all samples
// agree with it. e: the edge functions there; x, y: how they change from pixel to pixel.
bool wfvCoverage(WfvRay ray, vec3 e, vec3 x, vec3 y, bool rim)
{
  vec3 reach = WFV_PIXEL_SAFETY * (WFV_SAMPLE_REACH + wfvChordReach()) * (abs(x) + abs(y));
#if WFV_OWN_RAYS
  rim = rim || wfvTurns(ray.direction);
#elif WFV_CURVED_RAYS
  rim = true; // every sample has a depth of its own
#endif
  bool certain = wfvByChord || (!rim && all(greaterThan(abs(e), reach)));
  int mask = wfvByChord || (certain && all(greaterThan(e, vec3(0.0)))) ? -1 : 0;
  bool centre = certain || (ray.inside && wfvAllInside(e, wfvToChords(ray.direction, e, x, y)));
  // without samples, in a shader that still reckons with several, the centre decides
  mask = wfvSamples <= 1 && centre && !certain ? -1 : mask;
  wfvShown = ray.direction;
  for (int i = 0; i < wfvSamples && !certain; i++)
  {
    WfvRay at = wfvSurfaceRay(wfvSampleOffsets[i]);
    wfvSample = wfvSampleOffsets[i];
    vec3 there = vec3(wfvEdgesAt(at.direction));
    bool covered = at.inside && wfvAllInside(there, wfvToChords(at.direction, there, x, y));
    mask |= covered ? 1 << i : 0;
    wfvShown = covered && !centre ? at.direction : wfvShown;
  }
#ifdef GL_ARB_sample_shading
  gl_SampleMask[0] = mask;
#endif
  return mask != 0;
}
#else
bool wfvCoverage(WfvRay ray, vec3 e, vec3 x, vec3 y, bool rim)
{
  return wfvByChord || (wfvAllInside(e, wfvToChords(ray.direction, e, x, y)) && ray.inside);
}
#endif

bool wfvCovered(WfvRay ray, vec3 e)
{
#if WFV_EXACT && !WFV_MULTISAMPLE && !WFV_MEETS_CHORDS
  return wfvCoverage(ray, e, vec3(0.0), vec3(0.0), false);
#else
  bool rim;
#if WFV_EXACT
  mat2x3 pixel = wfvQuadSteps(ray, rim);
#else
  mat2x3 pixel = wfvRaySteps(ray, rim);
#endif
  vec3 x = wfvEdgeStep(ray.direction, pixel[0]);
  vec3 y = wfvEdgeStep(ray.direction, pixel[1]);
  return wfvCoverage(ray, e, x, y, rim);
#endif
}

// The ray of the pixel's centre, and the edge functions there.
WfvRay wfvLook(out vec3 e)
{
#if WFV_DOUBLES
  WfvWholeRay whole = wfvWholeRayAt();
  dvec3 edges = wfvEdgesAt(whole.direction);
  e = vec3(edges);
  wfvOfPlane = edges.x + edges.y + edges.z;
  return WfvRay(vec3(whole.direction), whole.inside);
#else
  WfvRay ray = wfvSurfaceRay(vec2(0.0));
  e = wfvEdgesAt(ray.direction);
  return ray;
#endif
}

void wfvPrepare()
{
  vec3 e;
  WfvRay ray = wfvLook(e);
#if !WFV_EXACT
  wfvByChord = (wfvMode & 1) == 0;
#endif
  bool covered = wfvCovered(ray, e);
#if WFV_MULTISAMPLE
  ray.direction = wfvShown;
  e = wfvEdgesAt(ray.direction);
#endif
  float approach = wfvApproach(ray.direction);
#if WFV_OWN_RAYS
  wfvFacing = wfvTurn;
#endif
#if WFV_EXACT
  wfvFront = gl_FrontFacing == (wfvFacing > 0.0);
  wfvB = wfvWeigh(e);
  wfvSetDistance(wfvMeet(ray.direction, approach));
  wfvSetSurface(ray.direction);
  bool meets = wfvFacing * approach > 0.0;
#else
  wfvFront = gl_FrontFacing;
  wfvB = wfvByChord ? wfvBary / (wfvBary.x + wfvBary.y + wfvBary.z) : wfvWeigh(e);
  wfvSetDistance(wfvByChord ? length(wfvPosition) : wfvMeet(ray.direction, approach));
  bool meets = wfvByChord || approach > 0.0;
#endif
#if WFV_EDGES
  wfvEdgePixels = wfvEdgeDistances();
#endif
  wfvInterpolate();
  wfvHide = !(covered && meets && wfvDepth >= 0.0 && wfvDepth <= 1.0);
#if WFV_EXACT && !WFV_MEETS_CHORDS
  wfvOrder(approach, e);
#endif
  wfvDepth += !wfvFront ? WFV_BEHIND : 0.0;
}
