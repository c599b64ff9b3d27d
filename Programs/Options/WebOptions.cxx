// SPDX-License-Identifier: BSD-3-Clause
#include "WebOptions.h"

#include "FilmOptions.h"
#include "RoomOptions.h"
#include "StereoChoice.h"
#include "Text/Messages.h"

#include <algorithm>
#include <cmath>

namespace widefov
{
namespace
{
constexpr double SteepestTilt = 90; // degrees; beyond, the view stands on its head

// A page shows films to one eye, because browsers do not keep two films in step.
std::string LayoutOf(const Options& o)
{
  return HasFilm(o) ? "left" : "separate";
}
}

void DeclareWeb(CLI::App& app, Options& o)
{
  OptionGroup group(app, "Output");
  group.Name("--web", "FOLDER", o.Web,
    "a web page that turns the panorama, or the film, in a new or empty folder: open index.html");
  group.Name("--title", "TEXT", o.Title, "title of the web page (name of the file or scene)");
}

void CompleteWeb(Options& o)
{
  if (o.Web.empty())
  {
    return;
  }
  const std::vector<std::string>& given = o.StereoGiven;
  if (HasTwoEyes(o) && std::find(given.begin(), given.end(), "--layout") == given.end())
  {
    o.Layout = LayoutOf(o);
  }
  if (HasFilm(o))
  {
    o.Outputs.push_back(o.Web + "/" + WebFilm);
  }
}

void CheckWeb(const Options& o)
{
  if (o.Web.empty())
  {
    if (!o.Title.empty())
    {
      FailUsage("--title is for web pages; give --web FOLDER, or leave it out");
    }
    return;
  }
  if (o.Projection != "equirectangular" || std::abs(o.View.Tilt) > SteepestTilt)
  {
    FailUsage("--web shows the projection equirectangular alone, tilted by at most 90 degrees; "
              "leave --projection or --tilt out");
  }
  if (HasRoom(o) || !o.Warp.empty() || !o.Projectors.empty())
  {
    FailUsage("--web does not go with --screens, --pose, --warp and --display; leave them out");
  }
  if (HasTwoEyes(o) && o.Layout != LayoutOf(o))
  {
    FailUsage("--web needs --layout " + LayoutOf(o) + "; leave --layout out");
  }
}
}
