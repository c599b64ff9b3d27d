// SPDX-License-Identifier: BSD-3-Clause
// Position in view coordinates of each corner of a shape that a stock geometry stage
// makes of a point, for vtkWideFoVDataPass; only behind a camera that is not wide.
out vec3 wfvPositionGSOutput;
uniform mat4 wfvClipToView;

void wfvKeepAndEmit()
{
  wfvPositionGSOutput = (wfvClipToView * gl_Position).xyz;
  EmitVertex();
}
#define EmitVertex() wfvKeepAndEmit()
