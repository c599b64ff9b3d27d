// SPDX-License-Identifier: BSD-3-Clause
// The functions whose accuracy GLSL leaves open or that it lacks, for the GPU only; the
// C++ side has the standard library's (ProjectionMath.h).

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

// The sine s and the cosine c of an angle, or both times anything, k quarter turns farther on.
WFV_FN vec2 wfvQuartersOn(float s, float c, float k)
{
  int quarters = int(k);
  float sign_ = (quarters & 2) != 0 ? -1.0 : 1.0;
  return (quarters & 1) != 0 ? vec2(sign_ * c, -sign_ * s) : vec2(sign_ * s, sign_ * c);
}

// Sine and cosine with absolute errors below 2e-7 for |x| up to 10: x without its whole
// quarter turns, taken off in two parts, and minimax polynomials to r^7 and r^8 on
// [-pi/4, pi/4], off by 2e-9 and 1e-10. Both for less than either alone
// costs in software; the accuracy of sin and cos is left open, and often 5e-7.
WFV_FN vec2 wfvSinCosOf(float r, float k) // of r and k quarter turns
{
  float t = r * r;
  float s = r + r * t * ((-1.9495636e-4 * t + 8.3319787e-3) * t - 0.16666651);
  float c = (2.4438451e-5 * t - 1.3887368e-3) * t + 4.1666647e-2;
  c = 1.0 - t * (0.5 - c * t);
  return wfvQuartersOn(s, c, k);
}

// x, at most 1, to twelve binary places: the product of two such numbers has no rounding.
WFV_FN float wfvCut(float x)
{
  return floor(x * 4096.0) * (1.0 / 4096.0);
}

// Sine and cosine of f quarter turns, from -1/2 to 1/2, and what the two were rounded by: within
// 1e-8 where f is exact. First factors have so few digits that their product with an f of few has no
// rounding.
WFV_FN vec4 wfvSinCosOfQuarters(float f)
{
  float t = f * f;
  float a = 1.57080078125 * f;
  float s = (((-4.5922891e-3 * t + 7.9675903e-2) * t - 0.64596294) * t - 4.4761644e-6) * f;
  float b = 1.234375 * t;
  float near = 1.0 - b;
  float c = (((9.0402167e-4 * t - 2.0860289e-2) * t + 0.25366924) * t + 6.744499e-4) * t;
  c = ((1.0 - near) - b) + c;
  float sine = a + s;
  float cosine = near + c;
  return vec4(sine, cosine, (a - sine) + s, (near - cosine) + c);
}

WFV_FN vec2 wfvSinCos(float x)
{
  float k = floor(x * 0.63661977236758134 + 0.5);
  return wfvSinCosOf((x - k * 1.5703125) - k * 4.8382679489661923e-4, k);
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

// Newton steps of an inverse at the most: from half the range, quadratic convergence reaches float32's
// end in fewer.
const int WFV_NEWTON_STEPS = 12;

// The step of a Newton iteration after which the next result is float32's last: the
// error of a step is about the square of the one before.
const float WFV_ROOT_STEP = 3e-4;

// Radians, to which float32 knows the ray of a place beside the border: wfvOnItsSide.
const float WFV_BESIDE_SEAM = 1.2e-7;

// The first five terms; the rest is under 4e-10 for |t| <= 0.1716.
WFV_FN float wfvAtanhSeries(float t)
{
  float s = t * t;
  return t * (1.0 + s * (1.0 / 3.0 + s * (0.2 + s * (1.0 / 7.0 + s / 9.0))));
}

// atanh for |x| < 1, by halving (1 + x) / (1 - x) = exp(2 atanh(x)) down to where the series
// serves.
WFV_FN float wfvAtanh(float x)
{
  float t = abs(x);
  if (t < 0.17)
  {
    return wfvAtanhSeries(x);
  }
  float m = (1.0 + t) / (1.0 - t);
  float k = 0.0;
  for (int i = 0; i < 32 && m > 1.41421356; i++)
  {
    m *= 0.5;
    k += 0.34657359027997265;
  }
  float r = k + wfvAtanhSeries((m - 1.0) / (m + 1.0));
  return x < 0.0 ? -r : r;
}

// exp(-x), and what it is less than 1 by, to the last digits of each, for x in [0, 20]: by the series
// of what is left beside halvings, r in [-0.3466, 0.3466], whose rest is under 6e-9. The logarithm of
// two is in two parts, the first of which times a number of halvings is exact.
WFV_FN vec2 wfvExpOfMinus(float x)
{
  float k = floor(x * 1.4426950408889634 + 0.5);
  float r = (x - k * 0.693359375) + k * 2.1219444005469058e-4;
  float s = 1.0 / 120.0 - r * (1.0 / 720.0 - r / 5040.0);
  s = 1.0 / 6.0 - r * (1.0 / 24.0 - r * s);
  float less = r * (1.0 - r * (0.5 - r * s));
  float e = (1.0 - less) / float(1 << int(k));
  return vec2(e, k == 0.0 ? less : 1.0 - e);
}

// Cube root of x >= 0, for the start of an iteration: GLSL's pow may err in the fifth
// digit, and one step of Newton's method mends that.
WFV_FN float wfvCbrt(float x)
{
  if (!(x > 0.0))
  {
    return 0.0;
  }
  float c = pow(x, 1.0 / 3.0);
  return (2.0 * c + x / (c * c)) / 3.0;
}
