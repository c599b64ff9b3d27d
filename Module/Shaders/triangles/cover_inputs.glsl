// SPDX-License-Identifier: BSD-3-Clause
// Fragment side of the pre-clip: what it is given of the triangle, and what it finds of it here.

flat in WFV_EDGE wfvEdge0;
flat in WFV_EDGE wfvEdge1;
flat in WFV_EDGE wfvEdge2;
flat in vec3 wfvPlane;
#if WFV_NON_CENTRAL || WFV_CURVED_RAYS
flat in vec3 wfvAnchor; // in the plane
#endif
#if !WFV_NON_CENTRAL
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
vec3 wfvChordErrors();
vec3 wfvToChords(vec3 direction, vec3 e, vec3 dx, vec3 dy);
bool wfvAllInside(vec3 e, vec3 toChords);

// By the plane; interpolated depth would err along edges that run away from the eye, and
// the position that corners are weighed to, beside the eye, where they are far.
void wfvSetDistance(float rho)
{
  wfvRho = rho;
  wfvDepth = wfvDepthInUnits(rho);
}
