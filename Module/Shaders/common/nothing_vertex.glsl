//VTK::System::Dec
// SPDX-License-Identifier: BSD-3-Clause
// For a prop whose shaders could not be edited, or are refused: every vertex is beyond the clip planes.
// It asks for what VTK complains of where nobody asks: of glyphs a matrix each.
in vec4 vertexMC;
in mat4 GCMCMatrix;

void main()
{
  gl_Position = vec4(2.0 + abs((GCMCMatrix * vertexMC).xyz), 1.0);
}
