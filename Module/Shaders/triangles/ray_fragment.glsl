// SPDX-License-Identifier: BSD-3-Clause
// The rays of a fragment: of its centre, of its samples, and how the direction changes
// from pixel to pixel.

// Where a sample lies inside a pixel, from its centre, pixels; one sample: the centre.
uniform int wfvSamples;
uniform vec2 wfvSampleOffsets[WFV_MOST_SAMPLES];

// NDC of the place so many pixels beside the centre of the fragment.
vec2 wfvPlaceBeside(vec2 offset)
{
  return wfvNdcOfPixel(gl_FragCoord.xy + offset);
}

// The picture's centre, pixels of the window, and the raw map's units a pixel.
uniform vec4 wfvPixelToMap;

#if WFV_MERIDIAN && WFV_STRAIGHT_SEAM
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
#endif

// Its ray.
WfvRay wfvRayAt(vec2 offset)
{
#if WFV_FLAT_RIM
  return wfvUnproject(wfvPlaceBeside(offset), wfvView);
#else
  vec2 p = gl_FragCoord.xy + offset - wfvPixelToMap.xy;
  vec2 m = p * wfvPixelToMap.zw;
  WfvRay ray = wfvRayOfMap(m, wfvView);
#if WFV_MERIDIAN && WFV_STRAIGHT_SEAM
  ray.direction = wfvCylinderDirection(p, m);
#endif
  return ray;
#endif
}

#if WFV_SAMPLED
// True where this pixel of the picture lies in pixels of the direction map that change
// evenly.
bool wfvIsSimple()
{
  vec2 at = wfvPixelOfNdc(wfvNdcOfPixel(gl_FragCoord.xy), wfvView);
  vec4 here = wfvDirectionTexel(wfvView, wfvNearestIndex(at.x, wfvView.tables.x),
    wfvNearestIndex(at.y, wfvView.tables.y));
  vec2 size = wfvViewport.zw * wfvTile.xy;
  bool fine = size.x >= wfvView.tables.x && size.y >= wfvView.tables.y;
  return fine && (int(here.w) & WFV_PIXEL_SIMPLE) != 0;
}
#endif

#if WFV_FACES
// The face of a cube that the picture shows there.
int wfvFaceBeside(vec2 offset)
{
  return wfvFaceAt(wfvPlaceBeside(offset) / wfvView.scale);
}
#endif

// The change of direction per pixel along one axis, by the ray of the next pixel or, where
// that is outside the map or on another face, of the one before.
vec3 wfvRayStep(WfvRay ray, vec2 axis)
{
  WfvRay next = wfvRayAt(axis);
  WfvRay before = wfvRayAt(-axis);
#if WFV_FACES
  next.inside = next.inside && wfvFaceBeside(axis) == wfvFaceBeside(vec2(0.0));
#endif
  return next.inside ? next.direction - ray.direction : ray.direction - before.direction;
}

// The change of direction per pixel along x and y, by the differences within this quad. rim:
// its four pixels are not all inside the map, or on one face, so these say nothing.
mat2x3 wfvQuadSteps(WfvRay ray, out bool rim)
{
#if WFV_SAMPLED
  // there may be a discontinuity before the next pixel: this one's own slopes, inside it
  rim = !wfvIsSimple();
  return mat2x3(
    2.0 * (wfvRayAt(vec2(0.25, 0.0)).direction - wfvRayAt(vec2(-0.25, 0.0)).direction),
    2.0 * (wfvRayAt(vec2(0.0, 0.25)).direction - wfvRayAt(vec2(0.0, -0.25)).direction));
#else
  float inside = ray.inside ? 0.0 : 1.0;
  rim = inside + abs(dFdx(inside)) + abs(dFdy(inside)) > 0.0;
#if WFV_FACES
  float face = float(wfvFaceBeside(vec2(0.0)));
  rim = rim || abs(dFdx(face)) + abs(dFdy(face)) > 0.0;
#endif
  return mat2x3(dFdx(ray.direction), dFdy(ray.direction));
#endif
}

// The same, at a rim by the rays of the next pixels.
mat2x3 wfvRaySteps(WfvRay ray, out bool rim)
{
  mat2x3 steps = wfvQuadSteps(ray, rim);
#if !WFV_SAMPLED
  if (rim)
  {
    steps = mat2x3(wfvRayStep(ray, vec2(1.0, 0.0)), wfvRayStep(ray, vec2(0.0, 1.0)));
  }
#endif
  return steps;
}
