// SPDX-License-Identifier: BSD-3-Clause
// Equi-angular cubemap: the sphere on the six faces of a cube, on each of which the angle,
// not its tangent, grows evenly: u = 4/pi atan(right / forward), v = 4/pi atan(up /
// forward), both in [-1, 1]. Three columns and two rows, as web video has them:
//   left            front           right            (upright)
//   bottom          back            top              (turned, up in the picture is +X)
// so that each row is one strip without a break. Source: Google, Bringing pixels front and
// center in VR video (2017); the layout is that of FFmpeg's v360 filter, "eac".
// Domain: the sphere, always all of it. Discontinuities: the borders between the faces: the
// strips bend there, and break from one row to the other.

// Centre of a face in the raw map, which reaches from -1 to 1 on both axes.
WFV_FN vec2 wfvFaceCentre(int face)
{
  int column = face < 3 ? face : face - 3;
  return vec2(2.0 / 3.0 * (float(column) - 1.0), face < 3 ? 0.5 : -0.5);
}

// Map of a direction on a face, carried on beyond its borders.
WFV_FN vec2 wfvProjectOnFace(vec3 p, int face, WfvView v)
{
  vec3 q = wfvInFace(p, face);
  vec2 centre = wfvFaceCentre(face);
  float perAngle = 4.0 / WFV_PI;
  return vec2((centre.x + perAngle / 3.0 * wfvAtan2(q.x, q.z)) * v.scale.x,
    (centre.y + perAngle / 2.0 * wfvAtan2(q.y, q.z)) * v.scale.y);
}

WFV_FN vec2 wfvProject(vec3 p, WfvView v)
{
  return wfvProjectOnFace(p, wfvFaceOf(p), v);
}

// Map of (lambda, phi) in radians.
WFV_FN vec2 wfvMap(vec2 angles, WfvView v)
{
  return wfvProject(wfvMeridianDirection(angles), v);
}

// The face that a point of the raw map lies on; outside the picture the nearest.
WFV_FN int wfvFaceAt(vec2 m)
{
  int column = m.x < -1.0 / 3.0 ? 0 : (m.x > 1.0 / 3.0 ? 2 : 1);
  return m.y < 0.0 ? column + 3 : column;
}

// Direction of a point of a face, from its centre: at most 1 on both axes, or more where its
// map is carried on beyond its borders.
WFV_FN vec3 wfvFaceDirection(vec2 onFace, int face)
{
  float quarter = 0.25 * WFV_PI;
  float a = quarter * onFace.x;
  float b = quarter * onFace.y;
  vec2 sa = wfvSinCos(a);
  vec2 sb = wfvSinCos(b);
  vec3 q = vec3(sa.x * sb.y, sb.x * sa.y, sa.y * sb.y);
  return wfvFromFace(q / wfvHypot(wfvHypot(q.x, q.y), q.z), face);
}

// From the centre of a face, as wfvFaceDirection takes it.
WFV_FN vec2 wfvOnFace(vec2 m, int face)
{
  vec2 centre = wfvFaceCentre(face);
  return vec2(3.0 * (m.x - centre.x), 2.0 * (m.y - centre.y));
}

WFV_FN WfvRay wfvRayOfMap(vec2 m, WfvView v)
{
  WfvRay ray;
  ray.inside = abs(m.x) <= WFV_BORDER && abs(m.y) <= WFV_BORDER;
  int face = wfvFaceAt(m);
  vec2 at = wfvOnFace(m, face);
  at = vec2(max(-1.0, min(1.0, at.x)), max(-1.0, min(1.0, at.y)));
  ray.direction = wfvFaceDirection(at, face);
  return ray;
}

// NDC rectangle of a rectangle of angles: all of the picture. The stages bound what they
// draw face by face.
WFV_FN vec4 wfvBounds(vec4 a, WfvView v)
{
  return vec4(-v.scale.x, -v.scale.y, v.scale.x, v.scale.y);
}
