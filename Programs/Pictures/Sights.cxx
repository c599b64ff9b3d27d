// SPDX-License-Identifier: BSD-3-Clause
#include "Sights.h"

#include "Options/StereoChoice.h"
#include "Text/Messages.h"

#include <algorithm>
#include <cmath>

namespace widefov
{
namespace
{
// Pixels along the longer side of a screen of which nobody says how many it has.
constexpr double LongerSide = 1024;

wfv::Screen Scaled(const wfv::Screen& s, double scale)
{
  return { s.LowerLeft * scale, s.LowerRight * scale, s.UpperRight * scale };
}

std::array<int, 2> SizeOf(const Options& o, const NamedScreen& screen)
{
  if (o.HasSize)
  {
    return o.Size;
  }
  if (screen.Size[0] > 0)
  {
    return screen.Size;
  }
  const double width = glm::length(screen.Corners.LowerRight - screen.Corners.LowerLeft);
  const double height = glm::length(screen.Corners.UpperRight - screen.Corners.LowerRight);
  const double density = LongerSide / std::max(width, height);
  const auto pixels = [density](double side) {
    return std::max(1, static_cast<int>(std::lround(density * side)));
  };
  return { { pixels(width), pixels(height) } };
}

bool IsGiven(const Options& o, const std::string& option)
{
  return std::find(o.StereoGiven.begin(), o.StereoGiven.end(), option) != o.StereoGiven.end();
}

std::vector<HeadPose> AllPoses(HeadObserver& observer)
{
  std::vector<HeadPose> poses;
  while (const std::optional<HeadPose> pose = observer.Next())
  {
    poses.push_back(*pose);
  }
  return poses;
}
}

Sights::Sights(const Options& o)
  : Given(o)
{
  wfv::StereoOptions& stereo = this->Given.View.Stereo;
  if (!o.Screens.empty())
  {
    const ScreensFile file = ReadScreens(o.Screens);
    this->Screens = file.Screens;
    if (ShowsCube(o) && this->Screens.size() > 1)
    {
      Fail(o.Screens + " has " + std::to_string(this->Screens.size()) +
        " screens; the volume of --stereo " + o.Stereo + " stands behind one");
    }
    for (NamedScreen& screen : this->Screens)
    {
      screen.Size = SizeOf(o, screen);
    }
    if (!IsGiven(o, "--ipd"))
    {
      stereo.InterpupillaryDistance =
        o.RoomScale * file.EyeSeparation.value_or(stereo.InterpupillaryDistance);
    }
  }
  HeadPose still;
  still.HasPosition = true;
  this->Poses = { still };
  if (!o.Poses.empty())
  {
    RecordedHead recorded(o.Poses);
    this->Poses = AllPoses(recorded);
  }
}

void Sights::CheckEyes(const Options& sight, std::size_t pose) const
{
  if (!sight.Screen)
  {
    return;
  }
  const std::vector<wfv::Eye> eyes = !HasTwoEyes(sight)
    ? std::vector<wfv::Eye>{ wfv::Eye::Middle }
    : std::vector<wfv::Eye>{ wfv::Eye::Left, wfv::Eye::Right };
  // a pose without a position turns the room with the head
  const wfv::Head head = sight.Head->HasPosition ? sight.Head->Head : wfv::Head();
  for (const wfv::Eye eye : eyes)
  {
    const wfv::vec3 at = wfv::EyeOf(head, sight.View.Stereo.InterpupillaryDistance, eye);
    if (!(wfv::LookThrough(sight.Screen->Corners, at).Distance > 0))
    {
      const std::string who = this->Given.Poses.empty()
        ? "the origin of "
        : "pose " + std::to_string(pose + 1) + " of " + this->Given.Poses + " is for ";
      Fail(who + this->Given.Screens + ", screen " + sight.Screen->Name +
        ": an eye is behind it or in its plane; correct its corners, or the head's place by "
        "--pose");
    }
  }
}

// The volume behind its screen: as wide and high as it, its depth in the measure of its width.
void Sights::PlaceVolume(Options& sight) const
{
  if (!sight.Screen || !ShowsCube(sight))
  {
    return;
  }
  wfv::StereoOptions& s = sight.View.Stereo;
  const wfv::Head head = sight.Head->HasPosition ? sight.Head->Head : wfv::Head();
  const wfv::Screen& screen = sight.Screen->Corners;
  const auto look = [&](wfv::Eye eye) {
    return wfv::LookThrough(screen, wfv::EyeOf(head, s.InterpupillaryDistance, eye));
  };
  const wfv::ScreenFrustum middle = look(wfv::Eye::Middle);
  s.Viewer = { { middle.Center.x, middle.Center.y } };
  s.Distance = 1 / middle.Half.x;
  s.Iod = std::max(0., look(wfv::Eye::Right).Center.x - look(wfv::Eye::Left).Center.x);
  const std::string problem = s.Model->Check(s, *wfv::FindProjection(sight.Projection));
  if (!problem.empty())
  {
    Fail(this->Given.Screens + ", screen " + sight.Screen->Name + ": " + problem +
      "; stand farther back, or give another --offset");
  }
}

std::vector<Options> Sights::Through(const Options& o, const HeadPose& head) const
{
  Options sight = o;
  sight.Head = head;
  sight.Head->Head.Position *= o.RoomScale;
  std::vector<Options> sights;
  for (const NamedScreen& screen : this->Screens)
  {
    sight.Screen = screen;
    sight.Screen->Corners = Scaled(screen.Corners, o.RoomScale);
    sight.Size = screen.Size;
    sight.View.Aspect = double(screen.Size[0]) / screen.Size[1];
    sights.push_back(sight);
  }
  return sights.empty() ? std::vector<Options>{ sight } : sights;
}

std::vector<Options> Sights::See(const Options& o, const HeadPose& head) const
{
  std::vector<Options> sights = this->Through(o, head);
  std::for_each(sights.begin(), sights.end(), [this](Options& sight) { this->PlaceVolume(sight); });
  return sights;
}

std::vector<Options> Sights::At(const Options& o, std::size_t pose) const
{
  std::vector<Options> sights = this->Through(o, this->Poses[pose]);
  for (Options& sight : sights)
  {
    if (this->Poses.size() > 1)
    {
      sight.Number = pose + 1;
    }
    this->CheckEyes(sight, pose);
    this->PlaceVolume(sight);
  }
  return sights;
}

std::vector<Options> Sights::Next()
{
  return this->Taken == this->Poses.size() ? std::vector<Options>()
                                           : this->At(this->Given, this->Taken++);
}

void Sights::Check(const Options& o) const
{
  for (std::size_t pose = 0; pose < this->Poses.size(); pose++)
  {
    this->At(o, pose);
  }
}

void CheckSights(const Options& o)
{
  const Sights sights(o);
  sights.Check(sights.GetGiven());
}
}
