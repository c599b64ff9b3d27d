//VTK::System::Dec
// SPDX-License-Identifier: BSD-3-Clause
// For a prop whose shaders could not be edited, or are refused (nothing_vertex.glsl).
const bool wfvDrawsNothing = true;

void main()
{
  if (wfvDrawsNothing)
  {
    discard;
  }
}
