// SPDX-License-Identifier: BSD-3-Clause
// Round maps end at a circle that geometry may reach across.
bool wfvOutsideDomain()
{
  vec2 ndc = (2.0 * (gl_FragCoord.xy - wfvViewport.xy) - wfvViewport.zw) / wfvViewport.zw;
  vec2 m = (ndc - wfvTile.zw) / wfvTile.xy / wfvView.scale;
  return wfvHypot(m.x, m.y) > wfvRadius(wfvView.maxAngle, wfvView);
}
