// SPDX-License-Identifier: BSD-3-Clause
#include "StateLog.h"

#include "Text/Messages.h"

#include <nlohmann/json.hpp>

namespace widefov
{
namespace
{
using Json = nlohmann::ordered_json;

Json Describe(const ViewerState::TimeState& time)
{
  return { { "step", time.Step }, { "steps", time.Steps }, { "time", time.Time },
    { "playing", time.Plays } };
}

Json Describe(const FrameCost& cost)
{
  Json json{ { "ms", cost.Milliseconds }, { "draws", nullptr }, { "props", nullptr },
    { "cluster_triangles", nullptr }, { "relaxation", nullptr }, { "coarse", cost.Coarse } };
  if (cost.Draws)
  {
    json["draws"] = { { "plain", cost.Draws->Plain }, { "preclip", cost.Draws->PreClip },
      { "tessellate", cost.Draws->Tessellate }, { "exact", cost.Draws->Exact } };
    json["props"] = { { "drawn", cost.Draws->Props }, { "culled", cost.Draws->PropsCulled } };
    json["cluster_triangles"] = { { "total", cost.Draws->Triangles },
      { "culled", cost.Draws->TrianglesCulled }, { "projected", cost.Draws->TrianglesProjected } };
    json["relaxation"] = cost.Draws->Relaxation;
  }
  return json;
}
}

std::string StateLine(const ViewerState& s, const Options& o)
{
  Json json{ { "event", s.Event }, { "frame", s.Frame }, { "pending", s.Pending },
    { "size", o.Size }, { "projection", o.Projection }, { "technique", o.TechniqueName },
    { "debug_view", o.DebugView }, { "stereo", o.Stereo }, { "layout", o.Layout },
    { "hfov", o.View.HorizontalFov }, { "vfov", o.View.VerticalFov }, { "tilt", o.View.Tilt },
    { "eye", o.Eye.value_or(Vector3{ { 0, 0, 0 } }) },
    { "direction", o.Direction.value_or(Vector3{ { 0, 0, -1 } }) },
    { "up", o.Up.value_or(Vector3{ { 0, 1, 0 } }) }, { "yaw", s.Yaw }, { "pitch", s.Pitch },
    { "cursor", s.Cursor }, { "under_cursor", nullptr }, { "full_screen", s.FullScreen },
    { "help", s.Help }, { "text", s.Text }, { "numbers", s.Numbers }, { "message", s.Message },
    { "screen", nullptr }, { "room_scale", o.RoomScale }, { "pose", nullptr },
    { "paused", s.Paused }, { "crosshair", nullptr },
    { "panel", s.HasPanel ? Json(s.Widgets) : Json(nullptr) }, { "time", nullptr } };
  if (s.Time)
  {
    json["time"] = Describe(*s.Time);
  }
  if (s.UnderCursor)
  {
    json["under_cursor"] = *s.UnderCursor;
  }
  if (!s.Screen.empty())
  {
    json["screen"] = s.Screen;
  }
  if (s.Pose)
  {
    json["pose"] = *s.Pose;
  }
  if (s.Crosshair)
  {
    json["crosshair"] = *s.Crosshair;
  }
  json.update(Describe(s.Cost));
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

StateLog::StateLog(const std::string& path)
  : Path(path)
{
  if (!path.empty())
  {
    this->File = std::fopen(path.c_str(), "w");
    if (this->File == nullptr)
    {
      Fail("--log " + path + " cannot be written; choose another file");
    }
  }
}

StateLog::~StateLog()
{
  if (this->File != nullptr)
  {
    std::fclose(this->File);
  }
}

void StateLog::Write(const ViewerState& state, const Options& options)
{
  if (this->File == nullptr)
  {
    return;
  }
  const std::string line = StateLine(state, options);
  if (std::fwrite(line.data(), 1, line.size(), this->File) != line.size() ||
    std::fflush(this->File) != 0)
  {
    Fail("--log " + this->Path + " cannot be written any more; make room on its disk");
  }
}
}
