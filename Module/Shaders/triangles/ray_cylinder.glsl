// SPDX-License-Identifier: BSD-3-Clause
// The rays of a cylindrical map (before ray_fragment.glsl).

// Pixels that are a quarter of a turn, a whole number in most pictures.
uniform vec2 wfvQuarterTurn;

// wfvSinCosOfQuarters of so many pixels, less k quarters, where pixels are alike. The quarters are
// taken off the pixels, exactly: what is rounded then is a share of the rest, not of up to half a
// turn; nothing where quarters are a power of two of pixels.
vec4 wfvSinCosOfPixels(float p, float k, float quarter)
{
  return wfvSinCosOfQuarters((p - k * quarter) / quarter);
}

// Quarter turns nearest to an angle.
float wfvQuartersOf(float angle)
{
  return floor(angle * 0.63661977236758134 + 0.5);
}

// Sine and cosine of the latitude, and what the cosine was rounded by.
vec3 wfvLatitudeAt(float p, float y)
{
  if (WFV_EVEN_LATITUDES)
  {
    float k = wfvQuartersOf(y); // -1, 0 or 1
    vec4 phi = wfvSinCosOfPixels(p, k, wfvQuarterTurn.y);
    return k != 0.0 ? vec3(k * phi.y, -k * phi.x, -k * phi.z) : vec3(phi.x, phi.y, phi.w);
  }
  vec2 phi = wfvLatitude(y);
  return vec3(phi.x, phi.y, 0.0);
}

// The direction of a place so many pixels from the centre of a cylindrical map, m in the map:
// rounded once.
vec3 wfvCylinderDirection(vec2 p, vec2 m)
{
  float k = wfvQuartersOf(m.x);
  vec4 lambda = wfvSinCosOfPixels(p.x, k, wfvQuarterTurn.x);
  vec3 phi = wfvLatitudeAt(p.y, max(-WFV_TOP, min(WFV_TOP, m.y)));
  vec3 first = vec3(wfvCut(lambda.x), wfvCut(lambda.y), wfvCut(phi.y));
  vec3 rest = (vec3(lambda.x, lambda.y, phi.y) - first) + vec3(lambda.z, lambda.w, phi.z);
  vec2 level = wfvQuartersOn(first.z * first.x + (first.z * rest.x + rest.z * lambda.x),
    first.z * first.y + (first.z * rest.y + rest.z * lambda.y), k);
  return vec3(level.x, phi.x, -level.y);
}
