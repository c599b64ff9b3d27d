// SPDX-License-Identifier: BSD-3-Clause
// Fragment side of lines, technique exact: where Newton's method starts, from the chords between knots.

float wfvScanned[2]; // distances of the starts from their chords

// Puts the two nearest chords between knots, not side by side, into the starts.
void wfvScan(vec2 p, float lo, float hi, float ref)
{
  float a = lo;
  vec2 from = wfvArcPixel(lo, ref);
  int last = -2;
  // see wfvRefine
  int knots = wfvLineKind == 2 ? 4 * WFV_KNOTS : 0;
  for (int i = 1; i <= knots; i++)
  {
    float b = i == 4 * WFV_KNOTS ? hi : clamp(wfvKnot(i), lo, hi);
    if (!(b > a))
    {
      continue;
    }
    vec2 to = wfvArcPixel(b, ref);
    vec2 r = wfvAcrossSeam(p - 0.5 * (from + to)) + 0.5 * (to - from);
    float t = wfvOnChord(r, to - from);
    float d = length(r - t * (to - from));
    WfvStart s = WfvStart(mix(a, b, t), lo, hi, ref);
    if (d < wfvScanned[0])
    {
      bool beside = last == i - 1;
      wfvStarts[1] = beside ? wfvStarts[1] : wfvStarts[0];
      wfvScanned[1] = beside ? wfvScanned[1] : wfvScanned[0];
      wfvStarts[0] = s;
      wfvScanned[0] = d;
      last = i;
    }
    else if (d < wfvScanned[1] && last != i - 1)
    {
      wfvStarts[1] = s;
      wfvScanned[1] = d;
    }
    a = b;
    from = to;
  }
}

#if WFV_NON_CENTRAL
// The starts between two angles, which a cut may part.
void wfvScanParts(vec2 p, float lo, float hi)
{
  if (wfvArcCut > lo && wfvArcCut < hi)
  {
    wfvScan(p, lo, wfvBeforeCut, wfvArcRef(lo, wfvArcCut));
    lo = wfvArcCut;
  }
  wfvScan(p, lo, hi, wfvArcRef(lo, hi));
}

// The starts on either side of a gap, or all along.
void wfvStartAnywhere(vec2 p)
{
  wfvScanned[0] = wfvScanned[1] = 1e9;
  wfvScanParts(p, wfvArcRange.x, min(wfvArcInner.x, wfvArcRange.y));
  if (wfvHasGap())
  {
    wfvScanParts(p, max(wfvArcInner.y, wfvArcRange.x), wfvArcRange.y);
  }
  wfvStartCount = wfvScanned[1] < 1e9 ? 2 : 1;
}
#else
// The starts for an arc of any kind.
void wfvStartAnywhere(vec2 p)
{
  wfvScanned[0] = wfvScanned[1] = 1e9;
  float lo = wfvArcRange.x;
  float hi = wfvArcRange.y;
  if (wfvArcCut < WFV_NO_CUT)
  {
    wfvScan(p, lo, wfvBeforeCut, wfvArcRef(lo, wfvArcCut));
    lo = wfvArcCut;
  }
  wfvScan(p, lo, hi, wfvArcRef(lo, hi));
  wfvStartCount = wfvScanned[1] < 1e9 ? 2 : 1;
}
#endif

void wfvStartDots()
{
  for (int i = 0; i < 2; i++)
  {
    float a = wfvLineEnds[i];
    wfvStarts[i] = WfvStart(a, a, a, wfvArcRef(a, a));
  }
  wfvStartCount = 2;
}

void wfvStartOnChord(vec2 p)
{
  wfvChordDistance(p);
  float lo = wfvArcRange.x;
  float hi = wfvArcRange.y;
  wfvStarts[0] = WfvStart(wfvBestAngle, lo, hi, wfvArcRef(lo, hi));
  wfvStartCount = 1;
}

// Chords from which the nearest point of what a face of a cube shows is looked for.
const int WFV_FACE_CHORDS = 4;

// The start on a face, where one chord is not enough.
void wfvStartOnFace(vec2 p)
{
  float lo = wfvArcRange.x;
  float hi = wfvArcRange.y;
  float nearest = 1e9;
  vec2 from = wfvArcPixel(lo, 0.0);
  for (int i = 0; i < WFV_FACE_CHORDS; i++)
  {
    vec2 to = wfvArcPixel(mix(lo, hi, float(i + 1) / float(WFV_FACE_CHORDS)), 0.0);
    float t = wfvOnChord(p - from, to - from);
    float d = length(p - mix(from, to, t));
    if (d < nearest)
    {
      nearest = d;
      wfvStarts[0] = WfvStart(mix(lo, hi, (float(i) + t) / float(WFV_FACE_CHORDS)), lo, hi, 0.0);
    }
    from = to;
  }
  wfvStartCount = lo <= hi ? 1 : 0;
}
