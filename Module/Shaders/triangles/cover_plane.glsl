// SPDX-License-Identifier: BSD-3-Clause
// Fragment side of the pre-clip of rays from one centre: the distance at which they meet the plane of
// the triangle.

// From the known direction on: of a surface seen nearly edge-on the terms of a product
// with the whole direction would cancel, and what they are rounded by would decide its distance.
#if WFV_DOUBLES
flat in double wfvOfPoints;
double wfvOfPlane = 0.0lf; // the edges' planes add up to the triangle's

float wfvApproach(vec3 direction)
{
  return float(wfvOfPlane);
}

double wfvFp64Distance()
{
  return wfvOfPoints / wfvOfPlane;
}

// Distance at which a ray meets the plane.
float wfvMeet(vec3 direction, float approach)
{
  return float(wfvFp64Distance());
}
#else
flat in vec3 wfvToward;
flat in vec2 wfvMeets;

float wfvApproach(vec3 direction)
{
  return wfvMeets.x + dot(wfvPlane, direction - wfvToward);
}

float wfvMeet(vec3 direction, float approach)
{
  return wfvMeets.y / approach;
}
#endif
