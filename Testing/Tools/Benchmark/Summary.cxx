// SPDX-License-Identifier: BSD-3-Clause
#include "Summary.h"

#include "Text/Messages.h"
#include "Plan.h"

#include <algorithm>
#include <functional>

namespace wfv
{
namespace bench
{
namespace
{
// The wide technique that everything is measured by.
const char* const Usual = "auto_0.25";

// What "the error" is: four measures, each small where a picture is right.
struct Measure
{
  const char* Name;
  std::function<double(const reference::Metrics&)> Of;
};

const std::vector<Measure>& Measures()
{
  static const std::vector<Measure> all{
    { "max_px",
      [](const reference::Metrics& m) { return std::min(m.MaxPx, reference::SearchLimit); } },
    { "p99_px",
      [](const reference::Metrics& m) { return std::min(m.P99Px, reference::SearchLimit); } },
    { "unexplained", [](const reference::Metrics& m) { return m.Unexplained; } },
    { "mismatched_pixels", [](const reference::Metrics& m) { return double(m.Mismatched); } },
  };
  return all;
}

std::string MovingText(Mode mode)
{
  switch (mode)
  {
    case Mode::Turn:
      return " while turning";
    case Mode::Film:
      return " in a film";
    case Mode::First:
      return " of first frames";
    default:
      return "";
  }
}

// The records of one scene.
class Group
{
public:
  std::vector<const Record*> Records;

  const Record* Find(const std::string& name) const
  {
    for (const Record* r : this->Records)
    {
      if (NameOf(r->Run) == name)
      {
        return r;
      }
    }
    return nullptr;
  }

  void AddRatio(Json& json, const std::string& a, const std::string& b) const
  {
    const Record* const x = this->Find(a);
    const Record* const y = this->Find(b);
    const std::optional<double> top = x ? MedianOf(*x) : std::nullopt;
    const std::optional<double> bottom = y ? MedianOf(*y) : std::nullopt;
    if (top && bottom)
    {
      const int samples = x->Run.Options.Samples;
      const std::string moving = MovingText(x->Run.Motion.Mode) +
        (samples > 1 ? " with " + std::to_string(samples) + " samples" : std::string());
      json["time " + a + " / " + b + moving + ", " + x->Scene] = *top / *bottom;
    }
  }

  // The least time of a cubemap whose error is no larger, over that of `name`.
  void AddEqualError(Json& json, const std::string& name, const Measure& measure) const
  {
    const Record* const ours = this->Find(name);
    if (!ours || !ours->Error || !MedianOf(*ours))
    {
      return;
    }
    const double error = measure.Of(ours->Error->Metrics);
    const std::string end = ", " + ours->Scene;
    std::optional<double> best;
    bool any = false;
    for (const Record* r : this->Records)
    {
      if (r->Run.Method != "cubemap" || !r->Error || !MedianOf(*r))
      {
        continue;
      }
      any = true;
      const double theirs = measure.Of(r->Error->Metrics);
      json[std::string(measure.Name) + " " + NameOf(r->Run) + " - " + name + end] = theirs - error;
      if (theirs <= error && (!best || *MedianOf(*r) < *best))
      {
        best = MedianOf(*r);
      }
    }
    if (any)
    {
      json["time of the cubemap at the " + std::string(measure.Name) + " of " + name + " / " +
        name + end] = best ? Json(*best / *MedianOf(*ours)) : Json(nullptr);
    }
  }
};

void AddGroup(Json& json, const Group& group)
{
  const int width = group.Records.front()->Run.Options.Size[0];
  const int density = EqualDensity(width);
  const std::string cubemap = "cubemap_" + std::to_string(density);
  for (const std::string name :
    { "auto_0.02", "auto_0.05", Usual, "auto_1", "exact", "preclip", "vertex", "perspective" })
  {
    group.AddRatio(json, name, "floor");
    group.AddRatio(json, name, cubemap);
    if (name != "perspective")
    {
      group.AddRatio(json, name, "perspective");
    }
  }
  for (const std::string name : { Usual, "exact" })
  {
    group.AddRatio(json, name, "vertex");
    group.AddRatio(json, name, std::string(SmoothCubeMap) + "_" + std::to_string(2 * density));
  }
  group.AddRatio(json, "stereo-omnidirectional", Usual);
  group.AddRatio(json, "stereo-omnidirectional", "exact");
  group.AddRatio(json, "stereo-offaxis", "perspective");
  for (const std::string name : { Usual, "exact" })
  {
    for (const Measure& measure : Measures())
    {
      group.AddEqualError(json, name, measure);
    }
  }
}

// "auto_0.25 equirectangular 360, 4 samples"
std::string RowOf(const Record& r)
{
  const widefov::Options& o = r.Run.Options;
  return NameOf(r.Run) + " " + o.Projection + " " + widefov::Text(o.View.HorizontalFov) + ", " +
    std::to_string(std::max(1, o.Samples)) + (o.Samples > 1 ? " samples" : " sample");
}
}

Json Summarize(const std::vector<Record>& records)
{
  std::vector<std::pair<std::string, Group>> groups;
  for (const Record& r : records)
  {
    if (groups.empty() || groups.back().first != r.Scene)
    {
      groups.push_back({ r.Scene, {} });
    }
    groups.back().second.Records.push_back(&r);
  }
  Json json = Json::object();
  for (const auto& group : groups)
  {
    AddGroup(json, group.second);
  }
  return json;
}

Json SummarizeTable1(const std::vector<Record>& records)
{
  Json json = Json::object();
  for (const Record& r : records)
  {
    for (const Record& base : records)
    {
      const bool perspective = base.Run.Method == "perspective" &&
        base.Run.Options.Samples == r.Run.Options.Samples && base.Scene == r.Scene;
      if (perspective && r.Run.Method != "perspective" && MedianOf(r) && MedianOf(base))
      {
        json["frame rate " + RowOf(r) + " / " + RowOf(base) + ", " + r.Scene] =
          *MedianOf(base) / *MedianOf(r);
      }
    }
  }
  return json;
}
}
}
