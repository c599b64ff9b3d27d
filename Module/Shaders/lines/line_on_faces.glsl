// SPDX-License-Identifier: BSD-3-Clause
// Lines, geometry stage, for maps of the faces of a cube: a rectangle for each face that shows
// some of the line. A face has no discontinuity, and little curvature.

const int WFV_FACE_COUNT = 6;

// Faces that the line is seen on.
int wfvCountFaces()
{
  int n = 0;
  for (int face = 0; face < WFV_FACE_COUNT; face++)
  {
    wfvKeepFace(face);
    n += wfvArcRange.x <= wfvArcRange.y ? 1 : 0;
  }
  return n;
}

void wfvEmitOnFaces(bool dots)
{
  // two dots are seen on few
  if (!dots && wfvCountFaces() > wfvQuadsLeft)
  {
    // more than the stage may emit: the whole window, and every pixel takes its own face
    wfvArcRange = wfvArcEnds.xy;
    wfvModeOut = 5;
    wfvMapOut = vec4(WFV_NO_CUT, 1.0, -WFV_NO_CUT, WFV_NO_CUT);
    wfvEmitWindow();
    return;
  }
  for (int face = 0; face < WFV_FACE_COUNT; face++)
  {
    wfvKeepFace(face);
    if (dots)
    {
      wfvEmitDots();
    }
    else if (wfvArcRange.x <= wfvArcRange.y)
    {
      WfvStretch s = wfvMeasure(wfvArcRange.x, wfvArcRange.y, 0.0);
      wfvModeOut = wfvModeOf(s);
      wfvModeOut = wfvModeOut == 2 ? 4 : wfvModeOut;
      wfvEmitStretch(s);
    }
  }
}
