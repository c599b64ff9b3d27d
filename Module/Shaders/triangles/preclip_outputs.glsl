// SPDX-License-Identifier: BSD-3-Clause
// Pre-clip of triangles: what leaves the stage, and what is known of the triangle until then.

#if WFV_INVOCATIONS > 1
layout(triangles, invocations = WFV_INVOCATIONS) in;
#else
layout(triangles) in;
#endif
layout(triangle_strip, max_vertices = WFV_EMIT_VERTICES) out;

#if WFV_FP64 && defined(GL_ARB_gpu_shader_fp64)
#define WFV_DOUBLES 1
#define WFV_EDGE dvec3
#else
#define WFV_DOUBLES 0
#define WFV_EDGE vec3
#endif
flat out WFV_EDGE wfvEdge0;  // planes through the eye and the edge opposite to corner i
flat out WFV_EDGE wfvEdge1;
flat out WFV_EDGE wfvEdge2;
flat out vec3 wfvPlane;  // normal of the triangle, away from the eye
#if WFV_NON_CENTRAL || WFV_CURVED_RAYS
flat out vec3 wfvAnchor; // a point of its plane
#elif WFV_DOUBLES
flat out double wfvOfPoints; // the plane times any of its points
#else
flat out vec3 wfvToward; // a direction near it, or 0
flat out vec2 wfvMeets;  // the plane times that direction, and times any of its points
#endif
#if !WFV_EXACT
out vec3 wfvBary;        // barycentric coordinates, used where not ray-tested
out vec3 wfvPosition;    // the surface, where not ray-tested
flat out vec3 wfvSlack;  // pixels by which edge i is widened to meet its chord; < 0: none
flat out vec4 wfvCorners01; // corners in the picture, see chord_fragment.glsl
flat out vec2 wfvCorner2;
#if WFV_MERIDIAN && WFV_STRAIGHT_SEAM
flat out vec4 wfvSeam; // where the edges cross the seam: three heights, and the seam's x
#endif
#endif
#if WFV_NON_CENTRAL
flat out vec3 wfvSpan0; // the edges opposite to corner i, from end to end
flat out vec3 wfvSpan1;
flat out vec3 wfvSpan2;
#endif
#if !WFV_EXACT || WFV_DEBUG_VIEW
flat out int wfvMode;    // bits: 1 ray-tested, more in wfvPlaceCorners
#endif

const int WFV_RAY_TESTED = 1;

#if WFV_MEETS_CHORDS
// Neighbours may be drawn by their chords: edges whose chord error is within the tolerance end there
// (chord_fragment.glsl).
flat out vec3 wfvSlack; // pixels between edge i and its chord, at the most; < 0: it ends at the edge
flat out vec4 wfvCorners01;
flat out vec2 wfvCorner2;
#if WFV_SEVERAL_CHORDS
flat out vec3 wfvCount; // of the chords of edge i
flat out vec3 wfvPlace0; // the corners, that chords lie between
flat out vec3 wfvPlace1;
flat out vec3 wfvPlace2;
#endif
vec3 wfvSlackHere = vec3(-1.0);
vec3 wfvCountHere = vec3(0.0);
#define WFV_LENS wfvTolerance
#else
#define WFV_LENS 0.0
#endif

// Pixels added round a covering shape, for the rounding of its own bounds.
#define WFV_PAD (1.5 + WFV_LENS)

// Angle added round a covering shape, radians: float32 rounding of angles.
const float WFV_ANGLE_PAD = 2e-6;

// Relative slack with which a triangle counts as holding a pole.
const float WFV_POLE_SLACK = 1e-5;

vec3 wfvP[3] = vec3[3](vec3(0.0), vec3(0.0), vec3(0.0));
int wfvVertexMode = 0;
vec3 wfvN[3] = vec3[3](vec3(0.0), vec3(0.0), vec3(0.0));
WFV_EDGE wfvE[3]; // the same, for the fragment stage
vec4 wfvT = vec4(0.0); // the plane, and dot(xyz, p) of its points: below 0 where seen from its front
vec3 wfvA = vec3(0.0);
#if WFV_DOUBLES
double wfvM = 0.0lf; // as wfvOfPoints
#else
vec3 wfvD = vec3(0.0); // as wfvToward, wfvMeets
vec2 wfvM = vec2(0.0);
#endif
vec3 wfvS = vec3(0.0);
vec3 wfvSpans[3]; // as wfvSpan0, ..
vec2 wfvC[3] = vec2[3](vec2(0.0), vec2(0.0), vec2(0.0)); // corners in the picture
vec4 wfvSeamPlaces = vec4(0.0);
float wfvChordBound = 0.0; // pixels: how far the edges surely stay from their chords
bool wfvCurved = false; // an edge curves by more than the tolerance
int wfvEmitted = 0;

#if WFV_EXACT
// order_fragment.glsl
flat out vec3 wfvEach;
flat out vec3 wfvRises;
vec3 wfvEachHere = vec3(0.0);
vec3 wfvRisesHere = vec3(0.0);
#endif

#if WFV_CURVED_RAYS
flat out vec2 wfvDepths; // curved_fragment.glsl
vec2 wfvDepthsHere = vec2(0.0); // NDC depths at which the triangle may be
#endif
