// SPDX-License-Identifier: BSD-3-Clause
// The six faces of the cube round the eye: left, front, right, bottom, back, top. Included
// before what is drawn, or looked up, face by face.

// Direction in the frame of a face (0 to 5 in that order): right, up, forward.
WFV_FN vec3 wfvInFace(vec3 p, int face)
{
  if (face < 3)
  {
    return face == 1 ? vec3(p.x, p.y, -p.z)
                     : (face == 0 ? vec3(-p.z, p.y, -p.x) : vec3(p.z, p.y, p.x));
  }
  return face == 4 ? vec3(p.y, p.x, p.z)
                   : (face == 3 ? vec3(p.z, p.x, -p.y) : vec3(-p.z, p.x, p.y));
}

WFV_FN vec3 wfvFromFace(vec3 q, int face)
{
  if (face < 3)
  {
    return face == 1 ? vec3(q.x, q.y, -q.z)
                     : (face == 0 ? vec3(-q.z, q.y, -q.x) : vec3(q.z, q.y, q.x));
  }
  return face == 4 ? vec3(q.y, q.x, q.z)
                   : (face == 3 ? vec3(q.y, -q.z, q.x) : vec3(q.y, q.z, -q.x));
}

// The face that a direction meets; on a border the same one always.
WFV_FN int wfvFaceOf(vec3 p)
{
  vec3 a = vec3(abs(p.x), abs(p.y), abs(p.z));
  if (p.z < 0.0 && a.z >= a.x && a.z >= a.y)
  {
    return 1;
  }
  if (a.x >= a.y && a.x >= a.z)
  {
    return p.x < 0.0 ? 0 : 2;
  }
  return a.z >= a.y ? 4 : (p.y < 0.0 ? 3 : 5);
}
