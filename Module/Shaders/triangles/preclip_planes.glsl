// SPDX-License-Identifier: BSD-3-Clause
// Pre-clip of triangles: the planes through the eye and each edge, and the triangle's own.
//
// View coordinates of a corner are rounded by its own distance from the eye. Seen at that
// distance the angle is nothing, but not where an edge or the triangle passes the eye much
// nearer than its corners are; nor does float32 tell from which side a triangle is seen that
// is nearly edge-on, or on which side of a ray, that a vertex all but meets, its edges pass. So
// where OpenGL has doubles the planes are computed in them, from the coordinates of the vertex
// buffer, and rounded last.

#if WFV_MODEL
in vec3 wfvModel[]; // eye_vertex.glsl
#ifdef GL_ARB_gpu_shader_fp64
uniform dmat3 wfvToView; // not rounded, as a float32 matrix is
#endif
uniform int wfvEyeKnown;
uniform vec3 wfvEyeHigh;
uniform vec3 wfvEyeLow;
#endif

// Of the nearest corner's distance: a triangle with a longer edge may pass the eye much nearer
// than its corners do.
const float WFV_LONG = 0.5;

bool wfvIsLong(vec3 lengths)
{
  float nearest = min(lengths.x, min(lengths.y, lengths.z));
  vec3 edges = vec3(length(wfvP[2] - wfvP[1]), length(wfvP[0] - wfvP[2]), length(wfvP[1] - wfvP[0]));
  return max(edges.x, max(edges.y, edges.z)) > WFV_LONG * nearest;
}

// Of a small triangle the direction to one of its corners, for the fragment stage.
vec3 wfvTowardOf(vec3 lengths)
{
  return wfvIsLong(lengths) ? vec3(0.0) : wfvP[0] / lengths.x;
}

#ifdef GL_ARB_gpu_shader_fp64
// Share of the product of the corners' distances below which a determinant is rounding:
// the eye has 48 bits here, there are three corners, and some room.
const double WFV_EDGE_ON = 1e-14lf;

// Corner i in the stage's own units, not tilted: planes are tilted once they are known.
dvec3 wfvFp64(int i)
{
  dvec3 p = dvec3(gl_in[i].gl_Position.xyz);
#if WFV_MODEL
  dvec3 relative = (dvec3(wfvModel[i]) - dvec3(wfvEyeHigh)) - dvec3(wfvEyeLow);
  p = wfvEyeKnown != 0 ? wfvToView * relative : p;
#endif
  return p / double(wfvScale());
}

#if WFV_FACES
// Radians, and pixels where that is less: by so much all edges are turned about the x axis. On the
// faces of a cube many rays meet vertices of a regular mesh round its middle exactly, and would be
// decided by the rounding of a plane and a direction, edge by edge; turned by a few times that,
// they miss them, and the edges round a vertex agree. Not on maps with a pole or an antipode, by
// which the least turn is many pixels.
#if WFV_FP64
const float WFV_EDGE_TURN = 4e-13; // rays are in double too
#else
const float WFV_EDGE_TURN = 4e-7;
#endif
const float WFV_EDGE_TURN_PIXELS = 1e-3;

vec3 wfvEdgeTurn()
{
  float pixel = 2.0 * wfvView.halfFov.y / (wfvViewport.w * wfvTile.y);
  return vec3(min(WFV_EDGE_TURN, WFV_EDGE_TURN_PIXELS * pixel), 0.0, 0.0);
}
#endif

// What wfvView.tilt has too few digits for.
uniform vec2 wfvTiltLow;

dvec3 wfvTiltFp64(dvec3 p)
{
  if (!WFV_TILTED)
  {
    return p;
  }
  dvec2 t = dvec2(wfvView.tilt) + dvec2(wfvTiltLow);
  return dvec3(p.x, t.x * p.y + t.y * p.z, t.x * p.z - t.y * p.y);
}

// Plane through the eye and the edge of corners i and j, the same to the last bit from both
// sides.
WFV_EDGE wfvEdgePlane(int i, int j)
{
  bool ordered = wfvOrdered(wfvP[i], wfvP[j]);
  dvec3 p = ordered ? wfvFp64(i) : wfvFp64(j);
  dvec3 q = ordered ? wfvFp64(j) : wfvFp64(i);
  dvec3 n = cross(p, q - p);
#if WFV_FACES
  n += cross(dvec3(wfvEdgeTurn()), n);
#endif
#if WFV_FP64
  dvec3 seen = wfvTiltFp64(n);
#else
  vec3 seen = wfvTilt(vec3(n), wfvView);
#endif
  return ordered ? seen : -seen;
}

// The triangle's own plane; w is 0 where it is seen edge-on. Sets wfvM, and wfvD for rays in float32.
vec4 wfvTrianglePlane(vec3 lengths)
{
  dvec3 p = wfvFp64(0);
  dvec3 q = wfvFp64(1);
  dvec3 r = wfvFp64(2);
  dvec3 normal = cross(q - p, r - p);
  double w = dot(normal, p);
  bool edgeOn = abs(w) <= WFV_EDGE_ON * length(p) * length(q) * length(r);
#if WFV_DOUBLES
  wfvM = w;
#else
  wfvD = wfvTowardOf(lengths);
  wfvM = vec2(float(dot(wfvTiltFp64(normal), dvec3(wfvD))), float(w));
#endif
  return vec4(wfvTilt(vec3(normal), wfvView), edgeOn ? 0.0 : float(w));
}
#else
// Without doubles from the nearer corner, or the farther one's rounding would count in full.
vec3 wfvEdgePlane(int i, int j)
{
  float a = dot(wfvP[i], wfvP[i]);
  float b = dot(wfvP[j], wfvP[j]);
  bool ordered = a != b ? a < b : wfvOrdered(wfvP[i], wfvP[j]);
  vec3 p = ordered ? wfvP[i] : wfvP[j];
  vec3 q = ordered ? wfvP[j] : wfvP[i];
  vec3 n = cross(p, q - p);
  return ordered ? n : -n;
}

// (No index is computed: that would put the corners into memory.)
vec4 wfvTrianglePlane(vec3 lengths)
{
  int nearest = lengths.x < lengths.y ? 0 : 1;
  nearest = lengths.z < min(lengths.x, lengths.y) ? 2 : nearest;
  vec3 normal = cross(wfvP[1] - wfvP[0], wfvP[2] - wfvP[0]);
  float w = dot(normal, nearest == 0 ? wfvP[0] : (nearest == 1 ? wfvP[1] : wfvP[2]));
  wfvD = wfvTowardOf(lengths);
  wfvM = vec2(dot(normal, wfvD), w);
  return vec4(normal, w);
}
#endif

#if WFV_NON_CENTRAL || WFV_CURVED_RAYS
// A point of the plane, for the fragment stage: the nearest corner; of a long triangle the foot
// of the perpendicular from the eye.
vec3 wfvAnchorOf(vec4 plane, vec3 lengths)
{
  if (wfvIsLong(lengths))
  {
    // in parts: squares of a small one's products are below the least float
    float largest = max(abs(plane.x), max(abs(plane.y), abs(plane.z)));
    vec3 n = plane.xyz / largest;
    return n * (plane.w / largest / dot(n, n));
  }
  float nearest = min(lengths.x, min(lengths.y, lengths.z));
  return lengths.x == nearest ? wfvP[0] : (lengths.y == nearest ? wfvP[1] : wfvP[2]);
}
#endif

// First of all.
void wfvReadCorners()
{
  wfvEmitted = 0;
#if WFV_RUNS > 1
  wfvMute = WFV_RUN > 0;
#endif
  for (int i = 0; i < 3; i++)
  {
    wfvP[i] = wfvTilt(gl_in[i].gl_Position.xyz, wfvView) / wfvScale();
  }
}

#if WFV_EXACT
// For the order beside folds (order_fragment.glsl). Once a triangle: for every fragment it took up to 6 % of
// the time of a picture.
void wfvFindRises()
{
  for (int i = 0; i < 3; i++)
  {
    float size = wfvTaxiLength(wfvN[i]);
    wfvEachHere[i] = size > 0.0 ? 1.0 / size : 0.0;
    wfvRisesHere[i] = dot(wfvT.xyz, wfvN[i]) * wfvEachHere[i];
  }
}
#endif

// Of a triangle whose plane is known. Inside, edge functions are positive from either side; so is
// the plane's.
void wfvFacePlanes(vec3 lengths)
{
  float facing = wfvT.w > 0.0 ? 1.0 : -1.0;
#if WFV_NON_CENTRAL || WFV_CURVED_RAYS
  wfvA = wfvAnchorOf(wfvT, lengths);
#endif
  wfvM *= facing;
  wfvT = vec4(facing * wfvT.xyz, wfvT.w);
  wfvE[0] = facing * wfvEdgePlane(1, 2);
  wfvE[1] = facing * wfvEdgePlane(2, 0);
  wfvE[2] = facing * wfvEdgePlane(0, 1);
  for (int i = 0; i < 3; i++)
  {
    wfvN[i] = vec3(wfvE[i]);
  }
#if WFV_EXACT
  wfvFindRises();
#endif
}
