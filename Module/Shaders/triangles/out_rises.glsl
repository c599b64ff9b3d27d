// SPDX-License-Identifier: BSD-3-Clause
// Pre-clip of triangles: how its plane rises from its edges, for the order beside folds.

flat out vec3 wfvEach; // order_fragment.glsl
flat out vec3 wfvRises;
vec3 wfvEachHere = vec3(0.0);
vec3 wfvRisesHere = vec3(0.0);

void wfvWriteRises()
{
  wfvEach = wfvEachHere;
  wfvRises = wfvRisesHere;
}

// Once a triangle: for every fragment it took up to 6 % of
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
