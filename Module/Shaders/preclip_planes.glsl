// SPDX-License-Identifier: BSD-3-Clause
// Pre-clip of triangles: the planes through the eye and each edge, and the triangle's own.
//
// View coordinates of a corner are rounded by its own distance from the eye. Seen at that
// distance the angle is nothing, but not where an edge or the triangle passes the eye much
// nearer than its corners are; nor does float32 tell from which side a triangle is seen that
// is nearly edge-on. There, and only there, the planes are computed in double, from
// the coordinates of the vertex buffer.

#if WFV_MODEL
in vec3 wfvModel[]; // eye_vertex.glsl
uniform mat4 WFV_TO_VIEW;
uniform int wfvEyeKnown;
uniform vec3 wfvEyeHigh;
uniform vec3 wfvEyeLow;
#endif

#ifdef GL_ARB_gpu_shader_fp64
// Share of the product of the corners' distances below which a determinant is rounding:
// the eye has 48 bits here, there are three corners, and some room.
const double WFV_EDGE_ON = 1e-14lf;

// Corner i in the stage's own units, not tilted: planes are tilted once they are known.
dvec3 wfvWhole(int i)
{
  dvec3 p = dvec3(gl_in[i].gl_Position.xyz);
#if WFV_MODEL
  dvec3 relative = (dvec3(wfvModel[i]) - dvec3(wfvEyeHigh)) - dvec3(wfvEyeLow);
  p = wfvEyeKnown != 0 ? dmat3(mat3(WFV_TO_VIEW)) * relative : p;
#endif
  return p / double(wfvScale());
}

// From corner i on, or from j.
vec3 wfvWholeEdgePlane(int i, int j, bool first)
{
  dvec3 a = wfvWhole(i);
  dvec3 b = wfvWhole(j);
  return wfvTilt(vec3(first ? cross(a, b - a) : cross(b, a - b)), wfvView);
}

vec4 wfvWholePlane(int nearest)
{
  dvec3 p = wfvWhole(0);
  dvec3 q = wfvWhole(1);
  dvec3 r = wfvWhole(2);
  dvec3 normal = cross(q - p, r - p);
  double w = dot(normal, nearest == 0 ? p : (nearest == 1 ? q : r));
  bool edgeOn = abs(w) <= WFV_EDGE_ON * length(p) * length(q) * length(r);
  return vec4(wfvTilt(vec3(normal), wfvView), edgeOn ? 0.0 : float(w));
}
#endif

// Plane through the eye and the edge of corners i and j, the same to the last bit from both
// sides: from the nearer corner, or the farther one's rounding would count in full. An edge
// that is seen under less than a right angle passes the eye no nearer than its nearer corner
// is, and float32 does.
vec3 wfvEdgePlane(int i, int j)
{
  float a = dot(wfvP[i], wfvP[i]);
  float b = dot(wfvP[j], wfvP[j]);
  bool ordered = a != b ? a < b : wfvOrdered(wfvP[i], wfvP[j]);
  vec3 p = ordered ? wfvP[i] : wfvP[j];
  vec3 q = ordered ? wfvP[j] : wfvP[i];
  vec3 n = cross(p, q - p);
#ifdef GL_ARB_gpu_shader_fp64
  if (dot(p, q) < 0.0)
  {
    n = wfvWholeEdgePlane(i, j, ordered);
  }
#endif
  return ordered ? n : -n;
}

// Share of the farthest corner's distance: a plane that passes the eye nearer than this, of
// a triangle whose longest edge is more than that, is computed in double. (And of the nearest
// corner's: one with a longer edge may pass the eye much nearer than its corners do.)
const float WFV_BESIDE = 0.1;
const float WFV_LONG = 0.5;

// A point of the plane, for the fragment stage: the nearest corner; for a triangle that may pass
// the eye much nearer than its corners do, the foot of the perpendicular from the eye.
vec3 wfvAnchorOf(vec4 plane, vec3 lengths)
{
  float nearest = min(lengths.x, min(lengths.y, lengths.z));
  vec3 edges = vec3(length(wfvP[2] - wfvP[1]), length(wfvP[0] - wfvP[2]), length(wfvP[1] - wfvP[0]));
  if (max(edges.x, max(edges.y, edges.z)) > WFV_LONG * nearest)
  {
    // in parts: squares of a small one's products are below the least float
    float largest = max(abs(plane.x), max(abs(plane.y), abs(plane.z)));
    vec3 n = plane.xyz / largest;
    return n * (plane.w / largest / dot(n, n));
  }
  return lengths.x == nearest ? wfvP[0] : (lengths.y == nearest ? wfvP[1] : wfvP[2]);
}

// Share of the longest edge times the farthest corner's distance squared: a determinant
// below may have either sign in float32, whose rounding is a twentieth.
const float WFV_UNSURE = 1e-6;

// The triangle's own plane; w, of the nearest corner, whose rounding is the least, is 0 where
// it is seen edge-on. (No index is computed: that would put the corners into memory.)
vec4 wfvTrianglePlane(vec3 lengths)
{
  int nearest = lengths.x < lengths.y ? 0 : 1;
  nearest = lengths.z < min(lengths.x, lengths.y) ? 2 : nearest;
  vec3 a = wfvP[1] - wfvP[0];
  vec3 b = wfvP[2] - wfvP[0];
  vec3 normal = cross(a, b);
  float w = dot(normal, nearest == 0 ? wfvP[0] : (nearest == 1 ? wfvP[1] : wfvP[2]));
#ifdef GL_ARB_gpu_shader_fp64
  float far = max(lengths.x, max(lengths.y, lengths.z));
  float longest = max(length(a), max(length(b), length(b - a)));
  bool beside = longest > WFV_LONG * far && abs(w) < WFV_BESIDE * far * length(normal);
  if (beside || abs(w) < WFV_UNSURE * far * far * longest)
  {
    return wfvWholePlane(nearest);
  }
#endif
  return vec4(normal, w);
}
