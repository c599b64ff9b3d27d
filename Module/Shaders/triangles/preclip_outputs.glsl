// SPDX-License-Identifier: BSD-3-Clause
// Pre-clip of triangles: what leaves the stage of every triangle (out_*.glsl: of some), and what is known
// of the triangle until then.

#if WFV_INVOCATIONS > 1
layout(triangles, invocations = WFV_INVOCATIONS) in;
#else
layout(triangles) in;
#endif
layout(triangle_strip, max_vertices = WFV_EMIT_VERTICES) out;

flat out WFV_EDGE wfvEdge0;  // planes through the eye and the edge opposite to corner i
flat out WFV_EDGE wfvEdge1;
flat out WFV_EDGE wfvEdge2;
flat out vec3 wfvPlane;  // normal of the triangle, away from the eye

const int WFV_RAY_TESTED = 1; // of wfvMode

// Pixels added round a covering shape, for the rounding of its own bounds.
#define WFV_PAD 1.5

// Angle added round a covering shape, radians: float32 rounding of angles.
const float WFV_ANGLE_PAD = 2e-6;

// Relative slack with which a triangle counts as holding a pole.
const float WFV_POLE_SLACK = 1e-5;

vec3 wfvP[3] = vec3[3](vec3(0.0), vec3(0.0), vec3(0.0));
int wfvVertexMode = 0;
vec3 wfvN[3] = vec3[3](vec3(0.0), vec3(0.0), vec3(0.0));
WFV_EDGE wfvE[3]; // the same, for the fragment stage
vec4 wfvT = vec4(0.0); // the plane, and dot(xyz, p) of its points: below 0 where seen from its front
#if WFV_DOUBLES
double wfvM = 0.0lf; // as wfvOfPoints
#else
vec3 wfvD = vec3(0.0); // as wfvToward, wfvMeets
vec2 wfvM = vec2(0.0);
#endif
vec3 wfvS = vec3(0.0);
vec2 wfvC[3] = vec2[3](vec2(0.0), vec2(0.0), vec2(0.0)); // corners in the picture
vec4 wfvSeamPlaces = vec4(0.0);
float wfvChordBound = 0.0; // pixels: how far the edges surely stay from their chords
bool wfvCurved = false; // an edge curves by more than the tolerance
int wfvEmitted = 0;

void wfvWriteEdges()
{
  wfvEdge0 = wfvE[0];
  wfvEdge1 = wfvE[1];
  wfvEdge2 = wfvE[2];
  wfvPlane = wfvT.xyz;
}
