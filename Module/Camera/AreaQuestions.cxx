// SPDX-License-Identifier: BSD-3-Clause
#include "Camera/AreaQuestions.h"

#include "vtkWideFoVCamera.h"

#include "vtkMath.h"

#include <cmath>

namespace
{
// Degrees from the middle of a rectangle to its corner: behind the plane through the far corners
// there is a sixtieth of the distance, then.
constexpr double MostAngle = 10;

bool FindRay(vtkWideFoVCamera* camera, double aspect, const wfv::vec2& ndc, double direction[3])
{
  double origin[3];
  const double place[2] = { ndc.x, ndc.y };
  return camera->NDCToRay(place, aspect, origin, direction);
}

// Whether the middle of a side is seen within a pixel of the plane through its ends. across: from
// the side to what is a pixel beside it, NDC.
bool IsStraight(vtkWideFoVCamera* camera, double aspect, const wfv::vec2& from, const wfv::vec2& to,
  const wfv::vec2& across)
{
  double a[3];
  double b[3];
  double middle[3];
  double beside[3];
  const wfv::vec2 m = 0.5 * (from + to);
  const bool seen = FindRay(camera, aspect, from, a) && FindRay(camera, aspect, to, b) &&
    FindRay(camera, aspect, m, middle) && FindRay(camera, aspect, m + across, beside);
  double normal[3];
  vtkMath::Cross(a, b, normal);
  vtkMath::Normalize(normal);
  const double off = std::abs(std::asin(vtkMath::Dot(middle, normal)));
  return seen && off <= vtkMath::AngleBetweenVectors(middle, beside);
}
}

namespace wfv
{
bool AreaQuestions::Ask(const vec2& place, double depth)
{
  // two depths of each corner: left below, left above, right below, right above
  const bool begins = depth == 0;
  const bool near = this->Count % 2 == 0;
  const bool left = this->Count < 4;
  const bool below = this->Count % 4 < 2;
  if (this->Count == 2)
  {
    this->Last.y = place.y;
  }
  if (this->Count == 4)
  {
    this->Last.x = place.x;
  }
  const vec2 corner(left ? this->First.x : this->Last.x, below ? this->First.y : this->Last.y);
  const bool follows = this->Count > 0 && depth == (near ? 0 : 1) && place == corner;
  if (!follows)
  {
    this->First = place;
    this->Count = begins ? 1 : 0;
    return false;
  }
  this->Count = (this->Count + 1) % 8;
  return this->Count == 0;
}

bool AreaQuestions::IsBetweenPlanes(
  vtkWideFoVCamera* camera, double aspect, const vec2& pixel) const
{
  const vec2 a = this->First;
  const vec2 b = this->Last;
  double one[3];
  double other[3];
  const vec2 right(pixel.x, 0);
  const vec2 up(0, pixel.y);
  return FindRay(camera, aspect, a, one) && FindRay(camera, aspect, b, other) &&
    vtkMath::DegreesFromRadians(vtkMath::AngleBetweenVectors(one, other)) <= 2 * MostAngle &&
    IsStraight(camera, aspect, a, vec2(a.x, b.y), right) &&
    IsStraight(camera, aspect, vec2(b.x, a.y), b, -right) &&
    IsStraight(camera, aspect, a, vec2(b.x, a.y), up) &&
    IsStraight(camera, aspect, vec2(a.x, b.y), b, -up);
}
}
