// SPDX-License-Identifier: BSD-3-Clause
// A floor (vtkSkybox): a plane without an end, at its distance, which each eye sees from where its
// ray begins. Behind VTK's declarations.

// Steps of the search along a curve: to float32's end.
const int WFV_SKY_STEPS = 24;

vec3 wfvSkyEye = vec3(0.0); // world: where the ray begins

// Distance of the floor along the ray, view coordinates; below 0 where it does not meet it.
float wfvSkyFloorAt(WfvRay ray)
{
  vec3 eye = WFV_SKY_EYE(ray.direction);
  wfvSkyEye = wfvSkyFrom + wfvSkyTurned(eye);
  float ahead = dot(floorPlane.xyz, wfvSkyTurned(ray.direction));
  float above = dot(floorPlane.xyz, wfvSkyEye) + floorPlane.w;
  return ahead != 0.0 ? -above / ahead : -1.0;
}

// Of depth, NDC; what is not met counts as far.
float wfvSkyFloorDepth(WfvRay ray)
{
  float rho = wfvSkyFloorAt(ray);
  return rho >= 0.0 ? clamp(2.0 * wfvDepthOf(rho, wfvView) - 1.0, -1.0, 1.0) : 1.0;
}

void wfvPrepareFloor()
{
#if WFV_SHIFTED
  vec2 depth = vec2(-1.0, 1.0);
  for (int i = 0; i < WFV_SKY_STEPS; i++)
  {
    float middle = 0.5 * (depth.x + depth.y);
    bool behind = wfvSkyFloorDepth(wfvSkyRayAt(vec2(0.0), middle)) > middle;
    depth = behind ? vec2(middle, depth.y) : vec2(depth.x, middle);
  }
  wfvPrepareSkyAt(depth.y);
#else
  wfvPrepareSky();
#endif
  float rho = wfvSkyFloorAt(wfvSky);
  wfvSkyHide = wfvSkyHide || (rho >= 0.0 && rho < wfvView.radii.x);
}

// away: world, along the unit direction.
vec4 wfvSkyFloor(sampler2D tiles, vec3 direction, vec3 place, float away)
{
  float ahead = dot(floorPlane.xyz, direction);
  vec2 at = vec2(dot(floorRight, place), dot(floorFront, place));
  mat2 steps;
  for (int i = 0; i < 2; i++)
  {
    vec3 step_ = wfvSkySteps[i] / length(wfvSkyToWorld[0]);
    vec3 on = away * (step_ - direction * (dot(floorPlane.xyz, step_) / ahead));
    steps[i] = vec2(dot(floorRight, on), dot(floorFront, on)) / WFV_SKY_TILE;
  }
  return textureGrad(tiles, at / WFV_SKY_TILE, steps[0], steps[1]);
}

// The depth of what is so far away, world.
float wfvSkyDepth(float away)
{
  return clamp(wfvDepthOf(away / length(wfvSkyToWorld[0]), wfvView), 0.0, 1.0);
}
