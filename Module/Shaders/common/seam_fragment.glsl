// SPDX-License-Identifier: BSD-3-Clause
// Maps whose seam is curved end at it, and a point drawn as a square may reach across.
bool wfvOutsideDomain()
{
  return !wfvUnproject(wfvNdcOfPixel(gl_FragCoord.xy), wfvView).inside;
}
