// SPDX-License-Identifier: BSD-3-Clause
// Behind VTK's text of a volume in a flat picture: rays begin at the eye that is drawn, not at the
// camera's position, where VTK takes them from.
uniform vec3 wfvFlatEye; // view coordinates

vec3 computeRayDirection()
{
  vec4 eye = in_inverseVolumeMatrix[0] * in_inverseModelViewMatrix * vec4(wfvFlatEye, 1.0);
  return normalize(ip_vertexPos - eye.xyz);
}
