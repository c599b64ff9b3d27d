// SPDX-License-Identifier: BSD-3-Clause
// In double what glsl_math.glsl is in float32, for rays that are compiled a second time
// (Fp64Text.h). GLSL has no functions of angles in double. To 1e-12.

double wfvFp64Hypot(double x, double y)
{
  return sqrt(x * x + y * y);
}

// Taken off by quarter turns; minimax polynomials on [-pi/4, pi/4], off by 1e-14 and 9e-13.
dvec2 wfvFp64SinCos(double x)
{
  float k = floor(float(x) * 0.63661977236758134 + 0.5);
  double r = x - double(k) * 1.57079632679489662lf;
  double t = r * r;
  double s = -1.9841266916110632e-4lf + t * (2.7555990664728974e-6lf - t * 2.4805611712122475e-8lf);
  s = r + r * t * (-0.16666666666663885lf + t * (8.3333333310783228e-3lf + t * s));
  double c = 2.4800600180363809e-5lf - t * 2.7300933687212943e-7lf;
  c = 0.041666666664320264lf + t * (-1.3888887671652504e-3lf + t * c);
  c = (1.0lf - 0.5lf * t) + t * t * c;
  int quarters = int(k);
  double sign_ = double(1 - (quarters & 2));
  return (quarters & 1) != 0 ? dvec2(sign_ * c, -sign_ * s) : dvec2(sign_ * s, sign_ * c);
}

// What float32 says, turned by what is left.
double wfvFp64Atan2(double y, double x)
{
  double a = double(wfvAtan2(float(y), float(x)));
  dvec2 sc = wfvFp64SinCos(a);
  double along = x * sc.y + y * sc.x;
  double left = along > 0.0lf ? (y * sc.y - x * sc.x) / along : 0.0lf;
  return a + left;
}

// As wfvExpOfMinus, by more terms: the rest is under 1e-14.
dvec2 wfvFp64ExpOfMinus(double x)
{
  float k = floor(float(x) * 1.44269504 + 0.5);
  double r = x - double(k) * 0.69314718055994531lf;
  double s = 1.0lf;
  for (int i = 12; i > 1; i--)
  {
    s = 1.0lf - r / double(i) * s;
  }
  double e = (1.0lf - r * s) / double(1 << int(k));
  return dvec2(e, k == 0.0 ? r * s : 1.0lf - e);
}

// Of functions that no ray needs.
double wfvFp64Atanh(double x)
{
  return double(wfvAtanh(float(x)));
}

double wfvFp64Cbrt(double x)
{
  return double(wfvCbrt(float(x)));
}

// As WFV_ROOT_STEP: the next step of an iteration errs by about its square.
const double WFV_FP64_ROOT_STEP = 1e-6lf;

// As WFV_BESIDE_SEAM: more than functions of angles err here.
const double WFV_FP64_BESIDE_SEAM = 2e-12lf;
