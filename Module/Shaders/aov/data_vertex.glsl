// SPDX-License-Identifier: BSD-3-Clause
// The position of a vertex in view coordinates, for vtkWideFoVDataPass: its clip
// coordinates, as the stock stage leaves them, taken back (a wide camera's are view
// coordinates already).
out vec3 wfvPositionVSOutput;
uniform mat4 wfvClipToView;

void wfvKeepPosition()
{
  wfvPositionVSOutput = (wfvClipToView * gl_Position).xyz;
}
