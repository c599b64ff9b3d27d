// SPDX-License-Identifier: BSD-3-Clause
// Pre-clip of triangles: what the cheap bound does not settle, and the shape that covers one.

// True where the triangle holds a pole or an edge of it curves too much; sets wfvS, wfvChordBound
// and wfvCurved. Unless it is asked for nothing is measured.
//
// A loop, of no round then: software rendering runs through both sides of a branch, but through a loop only
// as long as a triangle of several needs it; and compilers unroll none whose rounds they cannot count,
// which would make long work of long text.
bool wfvMustCover(bool asked)
{
  vec3 a = wfvP[0];
  vec3 b = wfvP[1];
  vec3 c = wfvP[2];
  wfvChordBound = asked ? 0.0 : wfvChordBound;
  for (int i = asked ? 3 : 0; i > 0; i--)
  {
#if WFV_NON_CENTRAL
    vec2 e = wfvNcChordError(b, c);
#else
    vec2 e = wfvChordError(b, c);
#endif
    wfvS = vec3(wfvS.y, wfvS.z, e.x);
    wfvChordBound = max(wfvChordBound, e.y);
    // (no index is computed: that would put the corners into memory)
    vec3 first = a;
    a = b;
    b = c;
    c = first;
  }
  wfvCurved = min(wfvS.x, min(wfvS.y, wfvS.z)) < 0.0;
#if WFV_EXACT
  return true;
#elif WFV_FACES
  return wfvCurved;
#elif WFV_MERIDIAN
  return wfvCurved || wfvHolds(1, 1.0) || wfvHolds(1, -1.0);
#else
  return wfvCurved || wfvHolds(2, 1.0);
#endif
}

// Where the corners are in the picture, if that is asked for (as in wfvMustCover).
void wfvFindPlaces(bool asked)
{
  vec3 a = wfvP[0];
  vec3 b = wfvP[1];
  for (int i = asked ? 3 : 0; i > 0; i--)
  {
    wfvC[0] = wfvC[1];
    wfvC[1] = wfvC[2];
    wfvC[2] = wfvPixel(a);
    a = b;
    b = wfvP[2];
  }
}

// By a tight shape, grown by so many pixels, or by what holds all that the triangle may be seen in.
// (Loops of one round: see wfvMustCover.)
void wfvCoverBy(bool tight, float grow)
{
  bool front = wfvT.w < 0.0;
#if WFV_EXACT
  wfvFindPlaces(tight);
#endif
  for (int i = tight ? 1 : 0; i > 0; i--)
  {
    wfvCoverTight(grow, front);
  }
  for (int i = tight ? 0 : 1; i > 0; i--)
  {
    wfvCover(front);
  }
}
