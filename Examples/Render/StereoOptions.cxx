// SPDX-License-Identifier: BSD-3-Clause
#include "StereoOptions.h"

#include "Messages.h"
#include "Sights.h"
#include "StereoLayout.h"
#include "Stereo/Stereo.h"

#include <vtkNew.h>
#include <vtkStaticCellLocator.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace widefov
{
namespace
{
// The largest distance that may be asked for, scene units: squares of it still fit a float32.
constexpr double Most = 1e18;

// A number that one model alone takes; that it was given is kept.
void ModelNumber(OptionGroup& group, Options& o, const std::string& name, const std::string& type,
  double& target, const Range& range, const std::string& text)
{
  group.Add(name, type, Text(target), text + ", " + range.Describe(),
    [&o, &target, range](const std::string& option, const std::string& value) {
      target = ParseNumber(option, value, range);
      o.StereoGiven.push_back(option);
    });
}

// The options that a model has.
std::vector<std::string> OptionsOfModel(const std::string& model, bool screens)
{
  if (screens && (model == "offaxis" || model == "warped"))
  {
    // the rest follows from the screens
    return model == "warped" ? std::vector<std::string>{ "--ipd", "--offset" }
                             : std::vector<std::string>{ "--ipd" };
  }
  if (model == "omnidirectional")
  {
    return { "--ipd", "--pole-fade" };
  }
  if (model == "warped")
  {
    return { "--iod", "--distance", "--offset" };
  }
  return model == "offaxis" ? std::vector<std::string>{ "--separation", "--convergence" }
                            : std::vector<std::string>{};
}
}

void DeclareStereo(CLI::App& app, Options& o)
{
  OptionGroup group(app, "Stereo");
  wfv::StereoOptions& s = o.View.Stereo;
  group.Choice(
    "--stereo", o.Stereo, { "mono", "warped", "omnidirectional", "offaxis" }, {}, "stereo model");
  group.Add("--layout", "NAME", "anaglyph", "where the eyes go: " + Join(StereoLayoutNames()),
    [&o](const std::string& option, const std::string& value) {
      CheckChoice(option, value, StereoLayoutNames());
      o.Layout = value;
      o.StereoGiven.push_back(option);
    });
  ModelNumber(group, o, "--ipd", "D", s.InterpupillaryDistance, { 0, Most },
    "omnidirectional, screens: distance between the eyes, scene units");
  group.Add("--pole-fade", "A,B", "off",
    "omnidirectional: latitudes, degrees, between which the eyes' distance fades",
    [&o, &s](const std::string& option, const std::string& value) {
      const std::vector<double> fade = ParseNumbers(option, value, 2, 2);
      s.PoleFade = { { fade[0], fade[1] } };
      o.StereoGiven.push_back(option);
    });
  ModelNumber(group, o, "--iod", "D", s.Iod, { 0, 10 }, "warped: distance between the eyes, NDC");
  ModelNumber(group, o, "--distance", "D", s.Distance, { 0, Most },
    "warped: of the viewer from the plane of zero parallax, NDC");
  ModelNumber(
    group, o, "--offset", "D", s.Offset, { -1, 1 }, "warped: plane of zero parallax, NDC depth");
  ModelNumber(group, o, "--separation", "F", s.Separation, { 0, 0.5 },
    "offaxis: parallax far away, fraction of the width");
  ModelNumber(group, o, "--convergence", "D", s.Convergence, { 0, Most, true },
    "offaxis: distance of zero parallax, scene units");
}

void CompleteStereo(Options& o)
{
  o.View.Stereo.Model = wfv::FindStereoModel(o.Stereo);
  std::vector<std::string> known = OptionsOfModel(o.Stereo, !o.Screens.empty());
  if (o.Stereo != "mono")
  {
    known.emplace_back("--layout");
  }
  for (const std::string& given : o.StereoGiven)
  {
    if (std::find(known.begin(), known.end(), given) == known.end())
    {
      FailUsage(given + " does not go with --stereo " + o.Stereo +
        (known.empty() ? "; choose a stereo model" : ", which has " + Join(known)));
    }
  }
}

void CheckStereo(const Options& o)
{
  if (o.Stereo == "mono")
  {
    return;
  }
  if (o.Technique == Technique::CubeMap)
  {
    FailUsage("--technique cubemap has no stereo model; leave --stereo out");
  }
  if (!o.Aov.empty() && o.Layout != "left" && o.Layout != "right")
  {
    FailUsage("--aov is for one eye; give --layout left or --layout right");
  }
}

void WarnOfNearness(const Options& o, const Scene& scene, const Vector3& eye)
{
  if (o.Stereo != "omnidirectional")
  {
    return;
  }
  double nearest = std::numeric_limits<double>::infinity();
  for (const SceneProp& prop : scene.Props)
  {
    if (!prop.Surface || prop.Surface->GetNumberOfCells() == 0)
    {
      continue;
    }
    vtkNew<vtkStaticCellLocator> cells;
    cells->SetDataSet(prop.Surface);
    cells->BuildLocator();
    double point[3];
    vtkIdType cell = 0;
    int part = 0;
    double squared = 0;
    cells->FindClosestPoint(eye.data(), point, cell, part, squared);
    nearest = std::min(nearest, std::sqrt(squared));
  }
  const double ipd = o.View.Stereo.InterpupillaryDistance;
  if (ipd > nearest)
  {
    Say("warning: --ipd " + Text(ipd) + " is larger than the distance of the nearest surface, " +
      Text(nearest) + ": what is inside the circle of the eyes is not shown; choose a smaller one");
  }
}

std::vector<std::string> FilesOf(const Options& o, const std::string& output)
{
  const StereoLayout& layout = FindStereoLayout(o.Layout);
  const std::string name = NameOfScreen(o, output);
  if (o.Stereo == "mono" || !layout.Separate)
  {
    return { NameOfPose(o, name) };
  }
  return { NameOfPose(o, FileOfEye(layout, name, 0)), NameOfPose(o, FileOfEye(layout, name, 1)) };
}

PanoramaInfo DescribePanorama(const Options& o)
{
  PanoramaInfo info;
  // of two eyes in one file, or of a volume that was warped again, viewers know nothing
  const bool plain =
    o.Stereo == "mono" || (o.Stereo == "omnidirectional" && FindStereoLayout(o.Layout).IsOneEye());
  info.Equirectangular = plain && o.Projection == "equirectangular";
  info.HorizontalFov = o.View.HorizontalFov;
  info.VerticalFov = o.View.VerticalFov;
  return info;
}
}
