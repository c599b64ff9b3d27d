//VTK::System::Dec
// SPDX-License-Identifier: BSD-3-Clause
// For a prop whose shaders could not be edited: every vertex is beyond the clip planes.
in vec4 vertexMC;

void main()
{
  gl_Position = vec4(2.0, 2.0, 2.0, 1.0) + 0.0 * vertexMC;
}
