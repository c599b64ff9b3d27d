// SPDX-License-Identifier: BSD-3-Clause
#include "Camera/FlatQuestions.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>

namespace
{
// Of the cosine of an angle from the direction of view: a picker divides by it. Rays that are
// nearer to a right angle are turned by as much, in radians: a thousandth of a pixel at most.
constexpr double LeastCosine = 1e-6;
}

namespace wfv
{
void FlatQuestions::AskPosition(const double position[3])
{
  std::copy_n(position, 3, this->Position.begin());
  this->Last = Step::Position;
}

void FlatQuestions::AskFocalPoint(const double focalPoint[3])
{
  std::copy_n(focalPoint, 3, this->FocalPoint.begin());
  switch (this->Last)
  {
    case Step::Position:
      this->Last = Step::PickerFocalPoint;
      break;
    case Step::World:
      this->Last = Step::WorldFocalPoint;
      break;
    case Step::Direction:
      this->Last = Step::HandleFocalPoint;
      break;
    default:
      this->Last = Step::None;
  }
}

bool FlatQuestions::AskDirection()
{
  const bool asked = this->Last == Step::WorldFocalPoint;
  this->Last = asked ? Step::Direction : Step::None;
  return asked;
}

void FlatQuestions::AskDepth(const double world[3], double depth)
{
  const bool isFocal = std::equal(world, world + 3, this->FocalPoint.begin());
  if (isFocal && (this->Last == Step::PickerFocalPoint || this->Last == Step::HandleFocalPoint))
  {
    this->FocalDepth = depth;
    this->Last = this->Last == Step::PickerFocalPoint ? Step::PickerDepth : Step::HandleDepth;
    return;
  }
  if (this->Last == Step::PickerRange)
  {
    std::copy_n(world, 3, this->Middle.begin());
    this->FocalDepth = depth;
    this->Last = Step::PickerMiddle;
    return;
  }
  std::copy_n(world, 3, this->World.begin());
  this->WorldDepth = depth;
  this->Last = Step::World;
}

// The lower corner alone tells no widget: handles that have no place yet ask for it as well.
FlatQuestions::Asker FlatQuestions::AskCorner(const double ndc[2], bool afterLower)
{
  const bool lower = ndc[0] == -1 && ndc[1] == -1;
  const bool upper = afterLower && ndc[0] == 1 && ndc[1] == 1;
  this->Last =
    lower ? Step::WorldLower : Step::World; // several places may be asked for at one depth
  this->Middle = upper ? this->World : this->Middle;
  return upper ? Asker::WidgetCorner : Asker::Any;
}

FlatQuestions::Asker FlatQuestions::AskPlace(const double ndc[2], double& depth)
{
  const Step before = this->Last;
  const bool ofWorld = before == Step::World || before == Step::WorldLower;
  const bool follows = depth == (ofWorld ? this->WorldDepth : this->FocalDepth);
  this->Last = Step::None;
  if (!follows)
  {
    return Asker::Any;
  }
  switch (before)
  {
    case Step::PickerDepth:
      return Asker::Picker;
    case Step::PickerMiddle:
    case Step::PickerCorner:
      this->AtMiddle = before == Step::PickerMiddle;
      this->Last = this->AtMiddle ? Step::PickerCorner : Step::None;
      return Asker::PickerCorner;
    case Step::HandleDepth:
      depth = this->WorldDepth;
      return Asker::Any;
    case Step::World:
    case Step::WorldLower:
      return this->AskCorner(ndc, before == Step::WorldLower);
    default:
      return Asker::Any;
  }
}

void FlatQuestions::GetCorner(double diagonal, double place[3])
{
  std::copy_n(this->Middle.begin(), 3, place);
  place[0] += this->AtMiddle ? 0 : diagonal;
}

// A picker moves the place along the direction of view into the plane of the focal point, and sees
// along the line to there. So it is told the place where the ray, or what is opposite to it, meets
// that plane, and planes in front of the eye or behind it.
void FlatQuestions::Answer(const PickRay& ray, double place[3])
{
  double ahead[3];
  vtkMath::Subtract(this->FocalPoint.data(), this->Position.data(), ahead);
  const double distance = vtkMath::Normalize(ahead);
  const double cosine = vtkMath::Dot(ray.Direction.data(), ahead);
  const double least = std::copysign(std::max(std::abs(cosine), LeastCosine), cosine);
  for (int i = 0; i < 3; i++)
  {
    const double direction = ray.Direction[i] + (least - cosine) * ahead[i];
    place[i] = this->Position[i] + distance / least * direction;
  }
  this->Range = { ray.Range[0] * least, ray.Range[1] * least };
  this->Last = Step::PickerPlace;
}

bool FlatQuestions::AskRange(double range[2])
{
  const bool asked = this->Last == Step::PickerPlace;
  this->Last = asked ? Step::PickerRange : Step::None;
  std::copy_n(this->Range.begin(), asked ? 2 : 0, range);
  return asked;
}
}
