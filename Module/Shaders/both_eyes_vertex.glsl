// SPDX-License-Identifier: BSD-3-Clause
// A vertex of one of two instances: the first is seen by the left eye, the second by the right one,
// each in the layer of its own. Where one eye is drawn there is one instance and no layer, by the
// same program, so that nothing is rounded in another way.
void wfvChooseEye()
{
  wfvSeeBy(gl_InstanceID == 0 ? wfvEyes.x : wfvEyes.y);
#ifdef GL_ARB_shader_viewport_layer_array
  gl_Layer = gl_InstanceID;
#endif
}
