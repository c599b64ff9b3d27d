// SPDX-License-Identifier: BSD-3-Clause
// Maps whose seam is curved end at it, and a point drawn as a square may reach across.
bool wfvOutsideDomain()
{
  vec2 ndc = (2.0 * (gl_FragCoord.xy - wfvViewport.xy) - wfvViewport.zw) / wfvViewport.zw;
  return !wfvUnproject((ndc - wfvTile.zw) / wfvTile.xy, wfvView).inside;
}
