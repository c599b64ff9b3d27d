// SPDX-License-Identifier: BSD-3-Clause
// Pre-clip of triangles: a cheap bound of how far edges are from their chords.

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
