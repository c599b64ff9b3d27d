// SPDX-License-Identifier: BSD-3-Clause
// Depth of ray-tested triangles by which faces are in order that meet in a fold.

// Depth bias: radians at the least where edges are apart: more than a float32 ray is turned by, which is
// most on the faces of a cube, where edges are shifted (planes_turn.glsl).
const float WFV_BIAS = 6e-7;

// The bias is wider where a depth buffer tells faces that fold flat apart no nearer to their edge, but by
// none of these: radians, pixels. It is as much narrower as the angle whose tangent is the slope is less
// than the slope: two faces as far apart come out as far apart whichever way they are turned, the steeper
// one is moved by more, and a steep one not through what is near it. The third is a share of the way
// between the two nearest edges, which bounds a bias that moves a front away or a back nearer: the tip
// of a needle beside a fold, moved by more, falls behind the back, and so it does where the back beside
// it is moved by more. A front that comes nearer and a back that is put back stay in order whatever the other
// is moved by; but no needle is moved farther than the bias is wide, out of what lies between.
const vec3 WFV_WIDE_BIAS = vec3(5e-6, 0.01, 0.02);

// Of a face's slope against the ray, by which the bias moves it less: never by more than 50 times it, as it
// would where a splinter is seen edge-on.
const float WFV_STEEP = 0.02;

// A slope whose angle is as large as itself, and no division by 0.
const float WFV_FLAT = 0.001;

// Of each edge, found once a triangle: 1 over its length, 0 where it has none; and how the triangle's
// plane rises from it on.
flat in vec3 wfvEach;
flat in vec3 wfvRises;

#if WFV_DOUBLES
double wfvFineDepth = 0.0lf; // linear window depth here, not rounded, without a bias
#endif

// Sets the depth that tells what hides what: the pixel's own, but by the nearest edge that of the
// bias inside it. Where a surface folds, what hits it beyond the edge, by rounding alone, meets the plane of
// the face behind first, and just inside the faces are nearer to each other than a depth buffer can
// tell; the bias inside they are in order. Not among chords, which are not where edges are.
void wfvOrder(float approach, vec3 e)
{
  vec3 away = e * wfvEach;
  float inside = min(away.x, min(away.y, away.z));
  bool isFirst = inside == away.x;
  bool isSecond = inside == away.y;
  float between = away.x + away.y + away.z - max(away.x, max(away.y, away.z));
  vec2 shares = WFV_WIDE_BIAS.yz * vec2(fwidth(inside), between);
  float rise = isFirst ? wfvRises.x : isSecond ? wfvRises.y : wfvRises.z;
  float slope = rise / (abs(approach) + abs(rise) * WFV_STEEP);
  float steep = max(abs(slope), WFV_FLAT);
  float bias = max(WFV_BIAS, min(WFV_WIDE_BIAS.x * atan(steep) / steep, shares.x));
  float most = wfvFront == rise > 0.0 ? max(shares.y, bias / max(abs(slope), 1.0)) : shares.y;
  float nearer = max(min(bias, most) - inside, 0.0) * slope;
  bool known = min(wfvEach.x, min(wfvEach.y, wfvEach.z)) > 0.0 && approach != 0.0;
  float moved = known ? nearer : 0.0;
#if WFV_DOUBLES
  double rho = wfvFp64Distance() * (1.0 - double(moved));
  wfvFineDepth = double(wfvUnitDepth.x) * rho + double(wfvUnitDepth.y);
  wfvDepth = WFV_DEPTH_MAPPING(wfvView) == WFV_DEPTH_LINEAR ? float(wfvFineDepth)
                                                            : wfvDepthInUnits(float(rho));
#else
  wfvDepth = wfvDepthInUnits(wfvRho - wfvRho * moved);
#endif
}
