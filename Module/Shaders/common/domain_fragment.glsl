// SPDX-License-Identifier: BSD-3-Clause
// Round maps end at a circle that geometry may reach across.
bool wfvOutsideDomain()
{
  vec2 m = wfvNdcOfPixel(gl_FragCoord.xy) / wfvView.scale;
  return wfvHypot(m.x, m.y) > wfvRadius(wfvView.maxAngle, wfvView);
}
