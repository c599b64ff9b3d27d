// SPDX-License-Identifier: BSD-3-Clause
#include "DryRun.h"

#include "Options/OutputNames.h"
#include "Options/RoomOptions.h"
#include "Options/StereoChoice.h"
#include "Pictures/CameraSetup.h"
#include "Pictures/Sights.h"
#include "Pictures/Tiles.h"
#include "Text/Messages.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace widefov
{
namespace
{
using Json = nlohmann::ordered_json;

// The files, of every screen and pose.
Json OutputsOf(const Options& o)
{
  Json files = Json::array();
  const auto add = [&files](const Options& sight) {
    for (const std::string& output : sight.Outputs)
    {
      for (const std::string& file : FilesOf(sight, output))
      {
        files.push_back(file);
      }
    }
  };
  if (!HasRoom(o))
  {
    add(o);
  }
  else
  {
    Sights all(o);
    for (std::vector<Options> sights = all.Next(); !sights.empty(); sights = all.Next())
    {
      std::for_each(sights.begin(), sights.end(), add);
    }
  }
  const std::string page = o.Web.empty() ? "" : o.Web + "/index.html";
  for (const std::string& file : { page, o.Aov, o.Stats })
  {
    if (!file.empty())
    {
      files.push_back(file);
    }
  }
  return files;
}

Json ViewOf(const Options& o)
{
  Json json = { { "projection", o.Projection } };
  if (wfv::FindProjection(o.Projection)->Axis == wfv::Family::Azimuthal)
  {
    json["fov"] = o.View.HorizontalFov;
  }
  else
  {
    json["hfov"] = o.View.HorizontalFov;
    json["vfov"] = o.View.VerticalFov;
  }
  json["tilt"] = o.View.Tilt;
  return json;
}

Json EyesOf(const Options& o)
{
  using Number = wfv::StereoNumber;
  const wfv::StereoModel& model = StereoOf(o);
  const wfv::StereoOptions& s = o.View.Stereo;
  Json json = { { "stereo", o.Stereo } };
  json["layout"] = HasTwoEyes(o) ? Json(o.Layout) : Json(nullptr);
  json["ipd"] =
    model.Has(Number::InterpupillaryDistance) ? Json(s.InterpupillaryDistance) : Json(nullptr);
  json["pole_fade"] =
    model.Has(Number::PoleFade) && s.PoleFade[0] < s.PoleFade[1] ? Json(s.PoleFade) : Json(nullptr);
  return json;
}

// Points along x, y and z of each volume; null where there is none.
Json VolumesOf(const Scene& scene)
{
  Json volumes;
  for (const SceneVolume& volume : scene.Volumes)
  {
    const int* const d = volume.Data->GetDimensions();
    volumes.push_back({ d[0], d[1], d[2] });
  }
  return volumes;
}

Json SceneOf(const Options& o, const Scene& scene)
{
  const PrimitiveCount count = CountPrimitives(scene);
  std::array<double, 6> b;
  const bool bounded = SceneBounds(scene, b.data());
  return { { "scene", o.Scene.empty() ? Json(nullptr) : Json(o.Scene) }, { "files", o.Files },
    { "bounds", bounded ? Json(b) : Json(nullptr) },
    { "primitives",
      { { "triangles", count.Triangles }, { "lines", count.Lines }, { "points", count.Points } } },
    { "volumes", VolumesOf(scene) } };
}

Json PlanOf(const Options& o, const Scene& scene)
{
  const Pose pose = MakePose(scene, o);
  Json json = SceneOf(o, scene);
  json["eye"] = pose.Eye;
  json["direction"] = pose.Direction;
  json["up"] = pose.Up;
  json.update(ViewOf(o));
  json["size"] = o.Size;
  json["picture"] = SizeOfFile(o);
  json.update(EyesOf(o));
  json["technique"] = o.TechniqueName;
  json["tolerance"] = o.Tolerance;
  json["samples"] = o.Samples;
  json["outputs"] = OutputsOf(o);
  return json;
}

// A value as on the command line: numbers with commas between them.
std::string ValueText(const Json& value)
{
  if (value.is_number())
  {
    return Text(value.get<double>());
  }
  if (value.is_string())
  {
    return value.get<std::string>();
  }
  std::string text;
  for (const auto& [key, part] : value.items())
  {
    text += (text.empty()           ? ""
                : value.is_object() ? ", "
                                    : " ") +
      ValueText(part) + (value.is_object() ? " " + key : "");
  }
  return text;
}
}

std::string DryRunText(const Options& o, const Scene& scene)
{
  const Json plan = PlanOf(o, scene);
  if (o.Json)
  {
    return plan.dump(2) + "\n";
  }
  std::string text;
  for (const auto& [key, value] : plan.items())
  {
    text += value.is_null() || value.empty() ? "" : key + ": " + ValueText(value) + "\n";
  }
  return text;
}
}
