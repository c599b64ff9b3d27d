// Fragment side of the pre-clip: barycentric coordinates, coverage and depth of the
// primitive at this pixel, before the stock shader runs.

in vec3 wfvBary;
flat in vec3 wfvEdge0;
flat in vec3 wfvEdge1;
flat in vec3 wfvEdge2;
flat in vec4 wfvPlane;
flat in int wfvMode;
uniform float wfvTolerance;

vec3 wfvB;       // barycentric coordinates here
float wfvDepth;  // window depth here, 0 to 1
bool wfvHide;    // not covered: discarded once the stock shader has run

#if WFV_EDGES
vec3 wfvEdgePixels; // distance in pixels to the edge opposite to corner 0, 1, 2
#endif

void wfvInterpolate(); // generated: sets the stock shader's inputs from wfvB

bool wfvInside(float facing, float e, float slack, int tie)
{
  float s = facing * e + slack;
  return s > 0.0 || (s == 0.0 && tie != 0);
}

// Coverage by the ray of the pixel's centre. An edge that neighbours draw as a chord
// is widened by the tolerance, so that no pixel falls between the two.
bool wfvCovered()
{
  vec2 ndc = 2.0 * (gl_FragCoord.xy - wfvViewport.xy) / wfvViewport.zw - 1.0;
  WfvRay ray = wfvUnproject((ndc - wfvTile.zw) / wfvTile.xy, wfvView);
  vec3 e = vec3(dot(ray.direction, wfvEdge0), dot(ray.direction, wfvEdge1),
    dot(ray.direction, wfvEdge2));
  vec3 slack = 1.2 * wfvTolerance * (abs(dFdx(e)) + abs(dFdy(e)));
  slack *= vec3(float((wfvMode & 16) / 16), float((wfvMode & 32) / 32), float((wfvMode & 64) / 64));
  float facing = wfvPlane.w > 0.0 ? 1.0 : -1.0;
  float sum = dot(ray.direction, wfvPlane.xyz);
  float rho = wfvPlane.w / sum * wfvView.radii.y;
  wfvB = e / sum;
  wfvDepth = (rho - wfvView.radii.x) / (wfvView.radii.y - wfvView.radii.x);
  return ray.inside && facing * sum > 0.0 && wfvDepth >= 0.0 && wfvDepth <= 1.0 &&
    wfvInside(facing, e.x, slack.x, wfvMode & 2) && wfvInside(facing, e.y, slack.y, wfvMode & 4) &&
    wfvInside(facing, e.z, slack.z, wfvMode & 8);
}

void wfvPrepare()
{
  wfvB = wfvBary;
  wfvDepth = gl_FragCoord.z;
  bool covered = (wfvMode & 1) == 0 || wfvCovered();
#if WFV_EDGES
  vec3 slope = vec3(length(vec2(dFdx(wfvB.x), dFdy(wfvB.x))),
    length(vec2(dFdx(wfvB.y), dFdy(wfvB.y))), length(vec2(dFdx(wfvB.z), dFdy(wfvB.z))));
  wfvEdgePixels = abs(wfvB) / max(slope, vec3(1e-12));
#endif
  wfvInterpolate();
  wfvHide = !covered;
}
