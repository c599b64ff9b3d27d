//VTK::System::Dec
//VTK::Output::Dec
// SPDX-License-Identifier: BSD-3-Clause
// A smaller picture in place of what is there.
in vec2 texCoord;
uniform sampler2D wfvColors;
uniform sampler2D wfvDepths;

void main()
{
  gl_FragData[0] = texture(wfvColors, texCoord);
  gl_FragDepth = texture(wfvDepths, texCoord).r;
}
