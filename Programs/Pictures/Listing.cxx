// SPDX-License-Identifier: BSD-3-Clause
#include "Listing.h"

#include "Options/PresetChoice.h"
#include "Options/StereoChoice.h"
#include "Scenes/ArrayList.h"
#include "Scenes/FileKinds.h"
#include "Scenes/Scenes.h"
#include "System/Spread.h"
#include "System/StandardInput.h"
#include "Text/Messages.h"
#include "Text/ProjectionNames.h"

#include <nlohmann/json.hpp>

namespace widefov
{
namespace
{
using Json = nlohmann::ordered_json;

Json Describe(const wfv::Projection& p)
{
  Json options = Json::array();
  if (p.Axis == wfv::Family::Sampled)
  {
    options.push_back("direction-map");
  }
  else if (p.Axis == wfv::Family::Azimuthal)
  {
    options.push_back("fov");
  }
  else
  {
    options.push_back("hfov");
    options.push_back("vfov");
  }
  options.push_back("tilt");
  if (p.HasLens)
  {
    options.push_back("lens");
  }
  Json aliases = Json::array();
  for (const auto& [alias, name] : ProjectionAliases())
  {
    if (name == p.Name)
    {
      aliases.push_back(alias);
    }
  }
  return { { "name", p.Name }, { "aliases", aliases }, { "title", p.Title },
    { "properties", p.Properties }, { "min_hfov", p.MinHorizontalFov },
    { "max_hfov", p.MaxHorizontalFov }, { "min_vfov", p.MinVerticalFov },
    { "max_vfov", p.MaxVerticalFov }, { "options", options } };
}

std::string ProjectionList(bool json)
{
  Json list = Json::array();
  std::string names;
  for (const wfv::Projection* p : wfv::AllProjections())
  {
    list.push_back(Describe(*p));
    names += p->Name + "\n";
  }
  return json ? list.dump(2) + "\n" : names;
}

std::string SceneList(bool json)
{
  Json list = Json::array();
  std::string names;
  for (const SceneDefinition& d : SceneDefinitions())
  {
    list.push_back({ { "name", d.Name }, { "title", d.Title } });
    names += d.Name + "\n";
  }
  return json ? list.dump(2) + "\n" : names;
}

template <class Value>
Json Known(const std::optional<Value>& value)
{
  return value ? Json(*value) : Json(nullptr);
}

Json Times(const std::vector<double>& ms)
{
  if (ms.empty())
  {
    return { { "median", nullptr }, { "min", nullptr }, { "max", nullptr } };
  }
  const Spread spread = SpreadOf(ms);
  return { { "median", spread.Median }, { "min", spread.Least }, { "max", spread.Most } };
}

// Of a file that has none: said, for an empty text is no list.
std::string ArrayListText(const Options& options)
{
  std::vector<std::string> files{ options.ListArrays };
  const StandardInput input(files);
  const std::string text = ArrayListOf(files[0], options.Json);
  return text.empty() ? options.ListArrays + " has no arrays\n" : text;
}
}

std::string ListingText(const Options& options)
{
  std::string text;
  if (options.Version)
  {
    text += GetProgramName() + " " WIDEFOV_VERSION "\n";
  }
  if (options.ListProjections)
  {
    text += ProjectionList(options.Json);
  }
  if (options.ListScenes)
  {
    text += SceneList(options.Json);
  }
  if (options.ListFormats)
  {
    text += FormatList(options.Json);
  }
  if (!options.ListArrays.empty())
  {
    text += ArrayListText(options);
  }
  if (options.ListPresets)
  {
    text += PresetList(options.Json);
  }
  return text;
}

std::string StatsText(const Options& options, const Scene& scene, const RenderStats& stats)
{
  const PrimitiveCount count = CountPrimitives(scene);
  const bool mono = !HasTwoEyes(options);
  const Json json = { { "version", WIDEFOV_VERSION },
    { "gl",
      { { "vendor", stats.Gl.Vendor }, { "renderer", stats.Gl.Renderer },
        { "version", stats.Gl.Version } } },
    { "projection", options.Projection }, { "technique", options.TechniqueName },
    { "stereo", options.Stereo }, { "layout", mono ? Json(nullptr) : Json(options.Layout) },
    { "size", { options.Size[0], options.Size[1] } }, { "tiles", Known(stats.Tiles) },
    { "frames", stats.Milliseconds.size() }, { "ms", Times(stats.Milliseconds) },
    { "props",
      { { "total", stats.PropsTotal }, { "drawn", Known(stats.PropsDrawn) },
        { "culled", Known(stats.PropsCulled) } } },
    { "clusters",
      { { "total", Known(stats.Clusters) }, { "culled", Known(stats.ClustersCulled) } } },
    { "primitives",
      { { "triangles", count.Triangles }, { "lines", count.Lines }, { "points", count.Points } } },
    { "variants",
      { { "plain", Known(stats.PlainDraws) }, { "preclip", Known(stats.PreClipDraws) },
        { "tessellate", Known(stats.TessellateDraws) }, { "exact", Known(stats.ExactDraws) } } },
    { "cluster_triangles",
      { { "total", Known(stats.Triangles) }, { "culled", Known(stats.TrianglesCulled) },
        { "projected", Known(stats.TrianglesProjected) } } },
    { "anew",
      { { "props", Known(stats.ChosenProps) }, { "meshes", Known(stats.ClassifiedMeshes) } } },
    { "shaders",
      { { "programs", Known(stats.Shaders.Programs) }, { "ms", Known(stats.Shaders.Milliseconds) },
        { "later", Known(stats.Shaders.Later) },
        { "first_frame_ms", Known(stats.Shaders.FirstFrame) } } },
    { "parts_ms",
      { { "reading", Known(stats.Parts.Reading) }, { "clusters", Known(stats.Parts.Clusters) },
        { "shaders", Known(stats.Parts.Shaders) }, { "drawing", Known(stats.Parts.Drawing) },
        { "writing", Known(stats.Parts.Writing) } } } };
  return json.dump(2) + "\n";
}
}
