// SPDX-License-Identifier: BSD-3-Clause
// The functions whose accuracy GLSL leaves open, for the GPU only; the C++ side has
// std::atan2, std::hypot and std::log (ProjectionMath.h).

// atan2 with an absolute error below 3e-7 rad: octant reduction and an odd
// minimax polynomial of degree 17 on [0, 1] (Abramowitz and Stegun 4.4.49,
// whose own bound is 2e-8). atan2(0, 0) is 0.
WFV_FN float wfvAtan2(float y, float x)
{
  float ax = abs(x);
  float ay = abs(y);
  float big = max(ax, ay);
  float t = big > 0.0 ? min(ax, ay) / big : 0.0;
  float s = t * t;
  float r = 0.0028662257;
  r = r * s - 0.0161657367;
  r = r * s + 0.0429096138;
  r = r * s - 0.0752896400;
  r = r * s + 0.1065626393;
  r = r * s - 0.1420889944;
  r = r * s + 0.1999355085;
  r = r * s - 0.3333314528;
  r = t + t * s * r;
  r = ay > ax ? 1.5707963267948966 - r : r;
  r = x < 0.0 ? 3.14159265358979323846 - r : r;
  return y < 0.0 ? -r : r;
}

// sqrt(x^2 + y^2) without overflow or underflow of the squares.
WFV_FN float wfvHypot(float x, float y)
{
  float a = abs(x);
  float b = abs(y);
  float big = max(a, b);
  float t = big > 0.0 ? min(a, b) / big : 0.0;
  return big * sqrt(1.0 + t * t);
}

// Natural logarithm of x > 0: a power of two taken out, then 2 artanh(s) to s^9, whose
// remainder is below 1e-9. Implementations of log differ by up to 1e-5.
WFV_FN float wfvLog(float x)
{
  float e = floor(log2(x) + 0.5);
  float m = x * exp2(-e);
  float s = (m - 1.0) / (m + 1.0);
  float t = s * s;
  float r = 1.0 / 9.0;
  r = r * t + 1.0 / 7.0;
  r = r * t + 0.2;
  r = r * t + 1.0 / 3.0;
  r = r * t + 1.0;
  return 2.0 * s * r + e * 0.69314718055994531;
}
