// SPDX-License-Identifier: BSD-3-Clause
// Points wider than a pixel. A point of n pixels is the square of n pixels round the place of
// its centre in the map, wherever that place is: OpenGL would drop a point whose centre lies
// outside the window, and knows nothing of what is on the other side of a seam. So a square
// whose centre is outside shows the part that reaches inside, and beyond a seam it is
// continued from the other border:
//   at a straight seam  by the square itself, one turn further: the same pixels as on a
//                       cylinder of paper;
//   at a curved seam    by the square round the place that the map's formula, carried on
//                       beyond its border, gives the centre one turn further. What lies outside
//                       the border is cut by the fragment stage.
// At a pole, or the antipode of a round map, which the map draws as a segment or a circle, a
// point is not repeated: it stands where the map puts its centre. On the faces of a cube it
// goes over to the next face of its row, with which it is one strip, and ends where the row
// ends: what is on the other side of that border is turned and stands elsewhere, and half a
// square there would look like a point of its own.

layout(points) in;
layout(triangle_strip, max_vertices = 8) out;

uniform float wfvPointSize; // pixels
uniform int wfvFrontCulled; // what is seen from its front is not drawn: points always are

flat out float wfvPointDepth; // window depth, 0 to 1
out vec2 wfvPointCoord;       // what gl_PointCoord is for OpenGL's own points

// A square round a place of the picture (NDC), as far as the window shows it.
void wfvEmitSquare(vec2 centre, float rho, vec2 first, vec2 last)
{
  vec2 half_ = wfvPointSize / (wfvViewport.zw * wfvTile.xy);
  vec2 low = max(centre - half_, first);
  vec2 high = min(centre + half_, last);
  vec2 window = vec2(1.0) / wfvTile.xy;
  vec2 middle = -wfvTile.zw / wfvTile.xy;
  // also false where the place is no number
  if (!(all(lessThan(low, middle + window)) && all(greaterThan(high, middle - window))))
  {
    return;
  }
  for (int i = 0; i < 4; i++)
  {
    int right = wfvFrontCulled != 0 ? 2 : 1;
    vec2 at = vec2((i & right) != 0 ? high.x : low.x, (i & (3 - right)) != 0 ? high.y : low.y);
    gl_Position = wfvClip(at, rho);
    wfvPointDepth = wfvDepthOf(rho, wfvView);
    wfvPointCoord = vec2(0.5, -0.5) * (at - centre) / half_ + 0.5;
    wfvWriteCorners();
    gl_PrimitiveID = gl_PrimitiveIDIn;
    EmitVertex();
  }
  EndPrimitive();
}

#if WFV_MERIDIAN
// The same point as it is continued beyond the seam.
void wfvEmitContinued(vec3 p, vec2 centre, float rho)
{
  vec2 all_ = vec2(WFV_FAR_NDC);
#if WFV_STRAIGHT_SEAM
  float turn = 2.0 * wfvMap(vec2(WFV_PI, 0.0), wfvView).x;
  wfvEmitSquare(vec2(centre.x + (centre.x < 0.0 ? turn : -turn), centre.y), rho, -all_, all_);
#else
  vec2 angles = wfvMeridianAngles(p);
  // nearer to the centre of the map the formulas of some are not what continues them
  if (abs(angles.x) <= 0.5 * WFV_PI)
  {
    return;
  }
  // on the seam itself the sign of a longitude is noise: the side of the square counts
  float lambda = (centre.x < 0.0 ? -1.0 : 1.0) * (abs(angles.x) - 2.0 * WFV_PI);
  vec2 place = wfvMap(vec2(lambda, angles.y), wfvView);
  // the corner nearest to the middle of the map, if any, is inside
  vec2 half_ = wfvPointSize / (wfvViewport.zw * wfvTile.xy);
  vec2 nearest = sign(place) * max(abs(place) - half_, vec2(0.0));
  if (wfvUnproject(nearest, wfvView).inside)
  {
    wfvEmitSquare(place, rho, -all_, all_);
  }
#endif
}
#endif

void main()
{
  vec3 p = wfvTilt(gl_in[0].gl_Position.xyz, wfvView);
  float rho = wfvLength(p);
  // the eye itself, and what lies beyond a rim at which the map would fold, have no place in it
#if WFV_FLAT_RIM
  rho = p.z <= 0.0 ? rho : 0.0;
#endif
  if (!(rho > 0.0))
  {
    return;
  }
  vec2 centre = wfvProject(p, wfvView);
  vec2 first = vec2(-WFV_FAR_NDC);
  vec2 last = vec2(WFV_FAR_NDC);
#if WFV_FACES
  bool upper = wfvFaceOf(p) < 3;
  first.y = upper ? 0.0 : first.y;
  last.y = upper ? last.y : 0.0;
#endif
  wfvEmitSquare(centre, rho, first, last);
#if WFV_MERIDIAN
  wfvEmitContinued(p, centre, rho);
#endif
}
