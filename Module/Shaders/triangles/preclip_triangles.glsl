// SPDX-License-Identifier: BSD-3-Clause
// Pre-clip of triangles: which way each one is drawn.

// True where the triangle reaches the plane x = 0 behind the eye, or lies on more than
// one face of the cube.
bool wfvReachesSeam()
{
#if WFV_NON_CENTRAL
  return wfvNcReachesSeam();
#elif WFV_FACES
  int face = wfvFaceOf(wfvP[0]);
  return wfvFaceOf(wfvP[1]) != face || wfvFaceOf(wfvP[2]) != face;
#elif !WFV_MERIDIAN
  return false;
#endif
  for (int i = 0; i < 3; i++)
  {
    vec3 p = wfvP[i];
    vec3 q = wfvP[i == 2 ? 0 : i + 1];
    bool on = p.x == 0.0 && p.z > 0.0;
    bool crosses = (p.x < 0.0 && q.x > 0.0) || (p.x > 0.0 && q.x < 0.0);
    if (on || (crosses && wfvSeamPoint(p, q).z > 0.0))
    {
      return true;
    }
  }
  return false;
}

// Largest squared ratio of an edge to its distance (five degrees) for which the curvature may
// be bounded by its second derivative.
const float WFV_EASY_EDGE = 0.008;

// Pixels that the edges of a triangle may be off their chords for a tight cover.
const float WFV_TIGHT_ERROR = 1.0;

// Of the angles between the corners and the nearest singular point of the map.
vec3 wfvSines(vec3 lengths)
{
  vec3 sines;
  for (int i = 0; i < 3; i++)
  {
    vec3 p = wfvP[i];
#if WFV_FACES || WFV_SAMPLED
    sines[i] = 2.0; // no singular point
#elif WFV_MERIDIAN
    sines[i] = length(vec2(p.x, p.z)) / lengths[i];
#else
    sines[i] = p.z <= 0.0 ? 1.0 : length(vec2(p.x, p.y)) / lengths[i];
#endif
  }
  return sines;
}

// A cheap test that lets nearly every triangle of a fine mesh through: surely no pole,
// every chord within the tolerance or, where all are ray-tested, near enough to its edge. Sets
// wfvChordBound.
bool wfvEasy(vec3 lengths)
{
#if WFV_EXACT
  float tolerance = WFV_TIGHT_ERROR;
#else
  float tolerance = wfvTolerance;
#endif
  vec3 edges = vec3(dot(wfvP[1] - wfvP[2], wfvP[1] - wfvP[2]) / (lengths.y * lengths.z),
    dot(wfvP[2] - wfvP[0], wfvP[2] - wfvP[0]) / (lengths.z * lengths.x),
    dot(wfvP[0] - wfvP[1], wfvP[0] - wfvP[1]) / (lengths.x * lengths.y));
  float longest = max(edges.x, max(edges.y, edges.z));
  vec3 sines = wfvSines(lengths);
#if WFV_NON_CENTRAL
  vec3 own = vec3(dot(wfvP[1] - wfvP[2], wfvP[1] - wfvP[2]),
    dot(wfvP[2] - wfvP[0], wfvP[2] - wfvP[0]), dot(wfvP[0] - wfvP[1], wfvP[0] - wfvP[1]));
  vec2 turned = wfvNcEasy(lengths, max(own.x, max(own.y, own.z)));
  longest *= WFV_NC_WIDER;
#else
  const vec2 turned = vec2(0.0);
#endif
  float nearest = min(sines.x, min(sines.y, sines.z)) - sqrt(longest) - turned.x;
  nearest = min(nearest, 1.0);
  // the bound of wfv::Curvature (Bounds/Curvature.h), on both axes
  float sagitta = 0.125 * wfvView.curvature * length(0.5 * wfvViewport.zw * wfvTile.xy) * longest;
#if WFV_ROUND
  vec3 cosines = -vec3(wfvP[0].z, wfvP[1].z, wfvP[2].z) / lengths;
  float least = min(cosines.x, min(cosines.y, cosines.z)) - turned.x;
  nearest = least < wfvChordEnd() ? 0.0 : nearest;
#endif
  wfvChordBound = (sagitta + turned.y) / max(nearest * nearest, 1e-12);
  return longest <= WFV_EASY_EDGE && nearest > wfvSingularSine() && wfvChordBound <= tolerance;
}

// Surely nothing to see: all corners inside the near sphere or, for round maps of 180
// degrees and more, inside the cone that the domain leaves out.
bool wfvOutside(vec3 lengths)
{
  if (max(lengths.x, max(lengths.y, lengths.z)) * wfvScale() < wfvView.radii.x)
  {
    return true;
  }
#if !WFV_ROUND || WFV_NON_CENTRAL
  return false;
#else
  vec3 cosines = -vec3(wfvP[0].z, wfvP[1].z, wfvP[2].z) / lengths;
  float rim = cos(wfvView.maxAngle) - WFV_POLE_SLACK;
  return rim <= 0.0 && max(cosines.x, max(cosines.y, cosines.z)) < rim;
#endif
}

// True where the triangle holds a pole or an edge of it curves too much; sets wfvS, wfvChordBound
// and wfvCurved. Unless it is asked for nothing is measured.
//
// A loop, of no round then: software rendering runs through both sides of a branch, but through a loop only
// as long as a triangle of several needs it; and compilers unroll none whose rounds they cannot count,
// which would make long work of long text.
bool wfvMustCover(bool asked)
{
  vec3 a = wfvP[0];
  vec3 b = wfvP[1];
  vec3 c = wfvP[2];
  wfvChordBound = asked ? 0.0 : wfvChordBound;
  for (int i = asked ? 3 : 0; i > 0; i--)
  {
#if WFV_NON_CENTRAL
    vec2 e = wfvNcChordError(b, c);
#else
    vec2 e = wfvChordError(b, c);
#endif
    wfvS = vec3(wfvS.y, wfvS.z, e.x);
    wfvChordBound = max(wfvChordBound, e.y);
    // (no index is computed: that would put the corners into memory)
    vec3 first = a;
    a = b;
    b = c;
    c = first;
  }
  wfvCurved = min(wfvS.x, min(wfvS.y, wfvS.z)) < 0.0;
#if WFV_EXACT
  return true;
#elif WFV_FACES
  return wfvCurved;
#elif WFV_MERIDIAN
  return wfvCurved || wfvHolds(1, 1.0) || wfvHolds(1, -1.0);
#else
  return wfvCurved || wfvHolds(2, 1.0);
#endif
}

#if !WFV_EXACT
void wfvEmitSides(bool seam)
{
#if WFV_MERIDIAN
  float low = min(wfvP[0].x, min(wfvP[1].x, wfvP[2].x));
  float high = max(wfvP[0].x, max(wfvP[1].x, wfvP[2].x));
  if (seam && low < 0.0 && high > 0.0)
  {
    wfvEmitSide(1.0);
    wfvEmitSide(-1.0);
    return;
  }
  wfvEmitWhole(seam ? (high > 0.0 ? 1.0 : -1.0) : 0.0);
#else
  wfvEmitWhole(0.0);
#endif
}
#endif

// Where the corners are in the picture, if that is asked for (as in wfvMustCover).
void wfvFindPlaces(bool asked)
{
  vec3 a = wfvP[0];
  vec3 b = wfvP[1];
  for (int i = asked ? 3 : 0; i > 0; i--)
  {
    wfvC[0] = wfvC[1];
    wfvC[1] = wfvC[2];
    wfvC[2] = wfvPixel(a);
    a = b;
    b = wfvP[2];
  }
}

// By a tight shape, grown by so many pixels, or by what holds all that the triangle may be seen in.
// (Loops of one round: see wfvMustCover.)
void wfvCoverBy(bool tight, float grow)
{
  bool front = wfvT.w < 0.0;
#if WFV_MEETS_CHORDS
  wfvFindPlaces(tight || wfvHasChords); // chords lie between them
#elif WFV_EXACT
  wfvFindPlaces(tight);
#endif
  for (int i = tight ? 1 : 0; i > 0; i--)
  {
    wfvCoverTight(grow, front);
  }
  for (int i = tight ? 0 : 1; i > 0; i--)
  {
    wfvCover(front);
  }
}

#if WFV_EXACT
void wfvDraw(bool seam, bool easy)
{
  bool near = easy && !seam;
  float grow = wfvChordBound + WFV_LENS + WFV_TIGHT_PAD; // as wfvEasy has measured
  wfvMustCover(!near || WFV_DEBUG_VIEW == 1);
  wfvVertexMode = WFV_RAY_TESTED;
#if WFV_DEBUG_VIEW
  wfvVertexMode += WFV_KIND_UNIT * wfvCoverKind(seam, seam && WFV_STRAIGHT_SEAM == 0);
#endif
  wfvCoverBy(near || (!seam && wfvIsNarrow()), near ? grow : wfvNarrowGrow());
}
#else
// Of a triangle that wfvMustCover has measured.
void wfvCoverCurved(bool seam, bool discontinuous)
{
  wfvVertexMode = WFV_RAY_TESTED;
  wfvPlaceCorners(seam);
#if WFV_DEBUG_VIEW
  wfvVertexMode += WFV_KIND_UNIT * wfvCoverKind(seam, discontinuous);
#endif
  wfvCoverBy(!seam && wfvIsNarrow(), wfvNarrowGrow());
}

void wfvDraw(bool seam, bool easy)
{
  bool discontinuous = seam && WFV_STRAIGHT_SEAM == 0;
  // wfvMustCover also prepares the covering: it runs wherever one may follow
  if ((discontinuous || !easy) && (wfvMustCover(true) || discontinuous))
  {
    wfvCoverCurved(seam, discontinuous);
    return;
  }
  wfvVertexMode = 0;
#if WFV_DEBUG_VIEW
  wfvVertexMode += WFV_KIND_UNIT * wfvSplitKind(seam);
#endif
  wfvEmitSides(seam);
}
#endif

#if !WFV_NON_CENTRAL
// Radians: what float32 rays do not tell from a line.
const float WFV_GRAZING = 1e-6;

// From the eye to the nearest place of the edge p, q.
float wfvEdgeDistance(vec3 p, vec3 q)
{
  vec3 along = q - p;
  float share = clamp(-dot(p, along) / max(dot(along, along), 1e-30), 0.0, 1.0);
  return length(p + share * along);
}

// True of a triangle that reaches into the near sphere, and beyond it is seen as a band no wider
// than WFV_GRAZING: its plane passes the eye that closely. One that stays outside the sphere is drawn
// however thin, for its neighbours leave it the pixels that look at it.
bool wfvGrazes()
{
  // bounds of lengths, whose squares may be too small or too large for a float
  float normal = max(abs(wfvT.x), max(abs(wfvT.y), abs(wfvT.z)));
  float near = wfvView.radii.x / wfvScale();
  vec3 above = vec3(dot(wfvN[0] / normal, wfvT.xyz), dot(wfvN[1] / normal, wfvT.xyz),
    dot(wfvN[2] / normal, wfvT.xyz));
  float edges = min(wfvEdgeDistance(wfvP[1], wfvP[2]),
    min(wfvEdgeDistance(wfvP[2], wfvP[0]), wfvEdgeDistance(wfvP[0], wfvP[1])));
  bool reaches = min(above.x, min(above.y, above.z)) >= 0.0 || edges < near;
  return reaches && abs(wfvT.w) < WFV_GRAZING * near * normal;
}
#endif

#if WFV_MEETS_CHORDS
// An edge that chords stand for ends there; another is as it is.
void wfvFindChords()
{
  ivec3 chords = wfvReadChords();
  wfvCountHere = vec3(chords);
  for (int i = 0; i < 3; i++)
  {
    wfvSlackHere[i] = chords[i] > 0 ? wfvTolerance : -1.0;
  }
}
#endif

// Seen edge-on, or not a number: it covers no pixel.
bool wfvIsNothing()
{
#if WFV_NON_CENTRAL
  return wfvNcNothing();
#else
  return !(abs(wfvT.w) > 0.0);
#endif
}

void main()
{
  wfvReadCorners();
  vec3 lengths = vec3(length(wfvP[0]), length(wfvP[1]), length(wfvP[2]));
  wfvT = wfvTrianglePlane(lengths);
  if (wfvIsNothing() || wfvOutside(lengths))
  {
    return;
  }
  wfvFacePlanes(lengths);
#if WFV_MEETS_CHORDS
  wfvFindChords();
#endif
#if WFV_NON_CENTRAL
  wfvSetNc(lengths, wfvT.w > 0.0 ? 1.0 : -1.0);
#elif WFV_CURVED_RAYS
  wfvSetDepths(lengths);
#endif
#if !WFV_NON_CENTRAL
  if (wfvGrazes())
  {
    return;
  }
#endif
  bool seam = wfvReachesSeam();
#if WFV_SAMPLED
  wfvVertexMode = WFV_RAY_TESTED;
#if WFV_DEBUG_VIEW
  wfvVertexMode += WFV_KIND_UNIT * WFV_KIND_EXACT;
#endif
  wfvCover(wfvT.w < 0.0);
#else
  wfvDraw(seam, wfvEasy(lengths));
#endif
}
