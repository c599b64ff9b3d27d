// SPDX-License-Identifier: BSD-3-Clause
#include "Plan.h"

#include "SampledView.h"
#include "Stereo/Stereo.h"

#include <algorithm>
#include <cmath>

namespace wfv
{
namespace bench
{
namespace
{
// Of the perspective that the wide views are compared with, degrees.
constexpr double PerspectiveFov = 120;

// Drawn with where a method has no tolerance of its own, pixels.
constexpr double UsualTolerance = 0.25;

constexpr int Table1Samples = 4;

bool IsCubeMap(const std::string& method)
{
  return method == "cubemap" || method == SmoothCubeMap;
}

widefov::Technique TechniqueOf(const std::string& method)
{
  return IsCubeMap(method) ? widefov::Technique::CubeMap : widefov::TechniqueOf(method);
}

// Both eyes.
bool IsStereo(const std::string& method)
{
  return method.rfind("stereo-", 0) == 0;
}

void SetView(widefov::Options& o, const std::string& projection, double hfov)
{
  o.Projection = projection;
  o.View.Aspect = double(o.Size[0]) / o.Size[1];
  o.View.HorizontalFov = hfov;
  const bool planar = FindProjection(projection)->Axis == Family::Planar;
  const double half = 0.5 * hfov * WFV_PI / 180;
  const double flat = 2 * std::atan(std::tan(half) / o.View.Aspect) * 180 / WFV_PI;
  o.View.VerticalFov = planar ? flat : 0.5 * hfov;
}

std::vector<double> TolerancesOf(const PlanRequest& request, const std::vector<double>& few)
{
  if (request.Tolerance > 0)
  {
    return { request.Tolerance };
  }
  return request.Quick ? few : std::vector<double>{ 0.02, 0.05, UsualTolerance, 1 };
}

void Smooth(Run& run)
{
  if (run.Method == SmoothCubeMap)
  {
    run.Options.Size = { { 2 * run.Options.Size[0], 2 * run.Options.Size[1] } };
    run.Options.Samples = 0;
  }
}

// A projection at its widest.
void SetWidest(widefov::Options& o, const Projection& p)
{
  if (p.Axis == Family::Planar)
  {
    SetView(o, p.Name, PerspectiveFov);
    return;
  }
  o.Projection = p.Name;
  o.View.HorizontalFov = p.MaxHorizontalFov;
  o.View.VerticalFov = p.MaxVerticalFov;
}

class Maker
{
public:
  Maker(const PlanRequest& request, const widefov::Options& camera)
    : Request(request)
    , Camera(camera)
  {
    this->Camera.Size = request.Size;
    this->Camera.Samples = request.Samples;
    this->Camera.Tolerance = UsualTolerance;
    this->Camera.ExactPerspective = true;
    SetView(this->Camera, "equirectangular", 360);
  }

  // What a technique shows.
  void SetWide(widefov::Options& o) const
  {
    SetWidest(o, *FindProjection(this->Request.Projection));
    if (this->Request.Map)
    {
      SetWidest(o, SampledProjection());
      o.View.Map = this->Request.Map;
    }
  }

  Run Make(const std::string& method, std::optional<double> parameter = std::nullopt) const
  {
    Run run{ method, parameter, this->Camera, this->Request.Motion, {} };
    run.Options.TechniqueName = method;
    run.Options.Technique = TechniqueOf(method);
    if (IsCubeMap(method))
    {
      run.Options.CubeMapResolution = int(*parameter);
      Smooth(run);
    }
    else if (method != "floor")
    {
      this->SetWide(run.Options);
      run.Options.Tolerance = parameter.value_or(run.Options.Tolerance);
    }
    if (method == "perspective" || method == "stereo-offaxis")
    {
      run.Options.ExactPerspective = false; // stock VTK's
      run.Options.View.Map = nullptr;
      SetView(run.Options, "perspective", PerspectiveFov);
    }
    run.DirectionsOf = run.Options.View.Map ? this->Request.Projection : "";
    if (IsStereo(method))
    {
      run.Options.Stereo = method.substr(method.find('-') + 1);
      run.Options.View.Stereo.Model = FindStereoModel(run.Options.Stereo);
    }
    return run;
  }

  void Add(const std::string& method, const std::vector<double>& parameters = {})
  {
    const std::vector<std::string>& m = this->Request.Methods;
    const bool asked = m.empty() ? !(this->Request.Quick && IsStereo(method))
                                 : std::find(m.begin(), m.end(), method) != m.end();
    // the floor covers as many pixels as a view that stands; outside the scene, it would turn away
    const bool movesAway = method == "floor" && this->Request.Motion.Mode != Mode::Still;
    const bool besideNothing = method == SmoothCubeMap && this->Request.Samples <= 1;
    if (!asked || movesAway || besideNothing)
    {
      return;
    }
    for (const double parameter : parameters)
    {
      this->Runs.push_back(this->Make(method, parameter));
    }
    if (parameters.empty())
    {
      this->Runs.push_back(this->Make(method));
    }
  }

  std::vector<Run> Runs;

private:
  PlanRequest Request;
  widefov::Options Camera;
};
}

std::vector<std::string> MethodNames()
{
  return { "auto", "exact", "preclip", "vertex", "cubemap", SmoothCubeMap, "perspective", "floor",
    "stereo-omnidirectional", "stereo-offaxis" };
}

std::vector<std::string> ProjectionNames()
{
  std::vector<std::string> names;
  for (const Projection& p : Projections())
  {
    names.push_back(p.Name);
  }
  return names;
}

std::shared_ptr<const DirectionMap> MakeDirectionMap(
  const std::string& projection, const std::array<int, 2>& size)
{
  const Projection& p = *FindProjection(projection);
  widefov::Options o;
  o.Size = size;
  o.View.Aspect = double(size[0]) / size[1];
  SetWidest(o, p);
  return reference::SampleView(View(p, o.View), size[0], size[1]);
}

int EqualDensity(int width)
{
  return int(std::ceil(width / WFV_PI));
}

std::vector<Run> MakePlan(const PlanRequest& request, const widefov::Options& camera)
{
  Maker maker(request, camera);
  const double density = EqualDensity(request.Size[0]);
  maker.Add("auto", TolerancesOf(request, { 0.02, UsualTolerance }));
  maker.Add("exact");
  maker.Add("preclip");
  maker.Add("vertex");
  maker.Add("perspective");
  maker.Add("floor");
  maker.Add("stereo-omnidirectional");
  maker.Add("stereo-offaxis");
  maker.Add("cubemap",
    request.Quick ? std::vector<double>{ density }
                  : std::vector<double>{ density, 512, 1024, 2048, 4096 });
  maker.Add(SmoothCubeMap, { 2 * density });
  return maker.Runs;
}

std::vector<Run> MakeTable1(const PlanRequest& request, const widefov::Options& camera)
{
  PlanRequest one = request;
  one.Methods.clear();
  const Maker maker(one, camera);
  const std::vector<std::pair<std::string, double>> rows{ { "perspective", 120 },
    { "equirectangular", 120 }, { "equirectangular", 180 }, { "equirectangular", 270 },
    { "equirectangular", 360 }, { "hammer", 360 } };
  std::vector<Run> runs;
  for (const int samples : { 0, Table1Samples })
  {
    for (const auto& [projection, hfov] : rows)
    {
      const bool planar = projection == "perspective";
      for (const std::string method : { "auto", "preclip" })
      {
        Run run = planar ? maker.Make("perspective") : maker.Make(method);
        if (!planar && method == "auto")
        {
          run.Parameter = run.Options.Tolerance;
        }
        SetView(run.Options, projection, hfov);
        run.Options.Samples = samples;
        runs.push_back(run);
        if (planar)
        {
          break; // stock VTK draws it, whatever the technique
        }
      }
    }
  }
  return runs;
}
}
}
