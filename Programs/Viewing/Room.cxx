// SPDX-License-Identifier: BSD-3-Clause
#include "Room.h"

#include "Options/RoomOptions.h"
#include "Options/StereoChoice.h"
#include "Scenes/MeshBuilder.h"
#include "Text/Messages.h"

#include <algorithm>

namespace widefov
{
Room::Room(const Options& o, double poseRate, bool poseOnce)
  : All(o)
  , Played(this->All.GetPoses(), poseRate, poseOnce, o.Poses)
  , Head(*this->Played.Next())
{
  this->All.Check(this->GetGiven());
}

bool Room::Advance(double seconds)
{
  const std::size_t before = this->Played.GetNumber();
  this->Played.Advance(seconds);
  const std::optional<HeadPose> next = this->Played.Next();
  this->Head = next.value_or(this->Head);
  return next && this->Played.GetNumber() != before;
}

std::optional<std::size_t> Room::GetNumber() const
{
  return this->All.GetPoses().size() > 1 ? std::optional(this->Played.GetNumber()) : std::nullopt;
}

std::vector<Options> Room::See(const Options& o) const
{
  if (!HasRoom(this->GetGiven()))
  {
    return { o };
  }
  std::vector<Options> sights = this->All.See(o, this->Head);
  for (Options& sight : sights)
  {
    sight.Number = this->GetNumber();
  }
  return sights;
}

std::string Room::WhyNot(const Options& o) const
{
  try
  {
    this->All.Check(o);
  }
  catch (const Failure& failure)
  {
    return failure.what();
  }
  return "";
}

std::optional<Vector3> RayOf(const Options& sight, double x, double y)
{
  const wfv::Head head = sight.Head ? sight.Head->Head : wfv::Head();
  const bool stands = sight.Screen && sight.Head && sight.Head->HasPosition;
  wfv::vec3 ray;
  if (sight.Screen && !ShowsCube(sight))
  {
    const wfv::vec3 eye = stands ? head.Position : wfv::vec3(0);
    const wfv::ScreenFrustum through = wfv::LookThrough(sight.Screen->Corners, eye);
    ray = wfv::DirectionThrough(through, wfv::vec2(x, y));
  }
  else
  {
    const wfv::View view(*wfv::FindProjection(sight.Projection), sight.View);
    const wfv::ViewRay seen = view.Ray({ x, y });
    if (!seen.Inside)
    {
      return std::nullopt;
    }
    ray = seen.Direction;
  }
  if (!stands)
  {
    ray = wfv::TurnedWith(head, ray); // the display is on the head
  }
  return Vector3{ { ray.x, ray.y, ray.z } };
}

void ScaleRoom(Options& o, Vector3& eye, const Vector3& center, double factor)
{
  const double scale = std::clamp(o.RoomScale * factor, 1 / LargestRoomScale, LargestRoomScale);
  const double change = scale / o.RoomScale;
  o.RoomScale = scale;
  o.View.Stereo.InterpupillaryDistance *= change; // who stands in the room grows as much
  eye = center + change * (eye - center);
}
}
