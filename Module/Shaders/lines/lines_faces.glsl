// SPDX-License-Identifier: BSD-3-Clause
// Pre-clip of lines on the faces of a cube: cut where they go over from one face to
// another. Half a great circle meets four faces at the most.

const int WFV_FACE_PLANES = 6;

// Which side of the plane number k between faces p is on.
float wfvFacePlane(vec3 p, int k)
{
  float first = k < 4 ? p.x : p.y;
  float second = k < 2 ? p.y : p.z;
  return (k & 1) == 0 ? first - second : first + second;
}

void wfvEmitOnFaces()
{
  float cuts[WFV_FACE_PLANES];
  int n = 0;
  for (int k = 0; k < WFV_FACE_PLANES; k++)
  {
    float a = wfvFacePlane(wfvP[0], k);
    float b = wfvFacePlane(wfvP[1], k);
    if ((a < 0.0 && b > 0.0) || (a > 0.0 && b < 0.0))
    {
      float cut = a / (a - b);
      int at = n;
      for (; at > 0 && cuts[at - 1] > cut; at--)
      {
        cuts[at] = cuts[at - 1];
      }
      cuts[at] = cut;
      n++;
    }
  }
  // the planes go on where no face ends: stretches on one face are put together again
  float start = 0.0;
  float here = 0.0;
  int face = -1;
  for (int i = 0; i <= n; i++)
  {
    float next = i < n ? cuts[i] : 1.0;
    int f = wfvFaceOf(mix(wfvP[0], wfvP[1], 0.5 * (here + next)));
    if (face >= 0 && f != face)
    {
      wfvEmitStretch(start, here, float(face + 1));
      start = here;
    }
    face = f;
    here = next;
  }
  wfvEmitStretch(start, 1.0, float(face + 1));
}
