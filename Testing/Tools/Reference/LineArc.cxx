// SPDX-License-Identifier: BSD-3-Clause
#include "LineArc.h"

#include <algorithm>
#include <cmath>

namespace wfv
{
namespace reference
{
namespace
{
// Radians: a stretch so short is not parted further; what is still far apart is a jump.
constexpr double ShortestStretch = 1e-12;

// Sine below which a line counts as pointing at the eye: float32's, as the picture's.
constexpr double Radial = 4e-7;

// Scene units: a line through the eye is seen from as far away at the least.
constexpr double LeastSoftened = 1e-9;

// Pixels from border to border where the map closes across a straight seam, else 0.
double PeriodOf(const View& view, const Window& window)
{
  const Projection& p = view.GetProjection();
  const bool closes = p.Axis == Family::Meridian && p.StraightSeam;
  return closes ? window.Width * p.Map(vec2(WFV_PI, 0), view.GetParameters()).x : 0;
}
}

Arc::Arc(const Segment& s, const View& view, const Window& window, const FaceMap* face)
  : TheView(&view)
  , Face(face)
  , TheWindow(window)
  , From(s.From)
  , To(s.To)
  , Shortest(ShortestStretch)
{
  const StereoModel* const stereo = view.GetStereoModel();
  if (stereo && !stereo->Traits.OneCenter)
  {
    this->SetOwn();
    return;
  }
  const bool atEye = !(glm::length(s.From) > 0);
  this->First = glm::normalize(atEye ? s.To : s.From);
  const vec3 base = glm::length(s.To - s.From) < glm::length(s.To) ? s.To - s.From : s.To;
  const vec3 across = base - this->First * glm::dot(this->First, base);
  const double sine = glm::length(across);
  if (atEye || sine <= Radial * glm::length(base))
  {
    this->Dots = true;
    this->Span = !atEye && glm::dot(s.From, s.To) < 0 ? WFV_PI : 0;
    return;
  }
  this->Second = across / sine;
  this->Span = std::atan2(sine, glm::dot(this->First, s.To));
  const Projection& p = view.GetProjection();
  const vec3 normal = wfvTilt(glm::cross(this->First, this->Second), view.GetParameters());
  const double aside = p.Axis == Family::Meridian ? normal.y : normal.z;
  this->Shortest = std::abs(aside) <= ThroughPole ? 2 * ThroughPole : ShortestStretch;
  this->Period = PeriodOf(view, window);
}

void Arc::SetOwn()
{
  this->Own = true;
  const vec3 d = this->To - this->From;
  const double length = glm::length(d);
  this->Along = length > 0 ? d / length : vec3(0);
  const double from = glm::dot(this->From, this->Along);
  this->Foot = this->From - from * this->Along;
  const double radius = wfvFromMiddle(this->TheView->GetParameters());
  this->Softened = std::max(std::hypot(glm::length(this->Foot), radius), LeastSoftened);
  this->Begin = std::atan2(from, this->Softened);
  this->Span = std::atan2(from + length, this->Softened) - this->Begin;
  this->Period = PeriodOf(*this->TheView, this->TheWindow);
}

Sample Arc::OwnAt(double angle) const
{
  const WfvView& v = this->TheView->GetParameters();
  vec3 p = this->Foot + this->Softened * std::tan(this->Begin + angle) * this->Along;
  p = angle <= 0 ? this->From : (angle >= this->Span ? this->To : p);
  const WfvRayHit sight = this->TheView->GetStereoModel()->See(wfvTilt(p, v), v);
  Sample s;
  s.Angle = angle;
  s.Rho = sight.distance;
  this->Place(p, wfvUntilt(sight.direction, v), s);
  s.Counts = s.Counts && sight.seen;
  return s;
}

void Arc::Place(const vec3& point, const vec3& direction, Sample& s) const
{
  const View& view = *this->TheView;
  // behind the rim of a half sphere there is none
  const bool behind =
    view.GetProjection().FlatRim && wfvTilt(direction, view.GetParameters()).z > 0;
  s.Counts = !behind && (!this->Face || this->Face->Has(direction));
  const vec3 forward = view.Forward(point).Ndc;
  const vec2 ndc = this->Face ? this->Face->Ndc(direction) : vec2(forward.x, forward.y);
  s.Pixel =
    vec2(0.5 * (1 + ndc.x) * this->TheWindow.Width, 0.5 * (1 - ndc.y) * this->TheWindow.Height);
}

Sample Arc::At(double angle) const
{
  if (this->Own)
  {
    return this->OwnAt(angle);
  }
  Sample s;
  s.Angle = angle;
  s.Rho = this->RhoAt(angle);
  const vec3 direction = this->DirectionAt(angle);
  this->Place(this->Dots ? this->EndAt(angle) : direction, direction, s);
  return s;
}

vec3 Arc::EndAt(double angle) const
{
  return angle > 0 || !(glm::length(this->From) > 0) ? this->To : this->From;
}

vec3 Arc::DirectionAt(double angle) const
{
  return this->Dots ? glm::normalize(this->EndAt(angle))
                    : std::cos(angle) * this->First + std::sin(angle) * this->Second;
}

double Arc::RhoAt(double angle) const
{
  if (this->Dots)
  {
    return glm::length(this->EndAt(angle));
  }
  const double a = std::sin(angle) * glm::length(this->From);
  const double b = std::sin(this->Span - angle) * glm::length(this->To);
  const double t = angle <= 0 ? 0 : (angle >= this->Span ? 1 : a / (a + b));
  return glm::length(this->From + t * (this->To - this->From));
}
}
}
