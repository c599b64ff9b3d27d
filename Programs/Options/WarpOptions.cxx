// SPDX-License-Identifier: BSD-3-Clause
#include "WarpOptions.h"

#include "FilmOptions.h"
#include "RoomOptions.h"
#include "Text/Messages.h"

namespace widefov
{
namespace
{
// Range of a projector's gamma.
const Range Gammas{ 0.1, 10 };

void CheckWarp(const Options& o)
{
  if (!o.Warp.empty() && !o.Projectors.empty())
  {
    FailUsage("--warp and --display exclude each other; give one");
  }
  if (!o.Projectors.empty() && (o.HasProjection || o.HasFov || o.HasSize))
  {
    FailUsage("--display says what its projectors show; leave --projection, fields of view and "
              "--size out");
  }
  if (!o.DirectionMap.empty() || !o.LensFile.empty() || !o.Borders.empty() || HasRoom(o) ||
    HasFilm(o))
  {
    FailUsage("--warp and --display go neither with --direction-map, --lens-file and --borders nor "
              "with rooms and films; leave these out");
  }
  if (!o.Projectors.empty() && !(o.Aov.empty() && o.Stats.empty()))
  {
    FailUsage("--aov and --stats are for one picture, not for those of --display; leave them out");
  }
}
}

void DeclareWarp(CLI::App& app, Options& o)
{
  OptionGroup group(app, "Projectors");
  group.Name("--warp", "FILE", o.Warp,
    "calibration of a projector; the projection is that of the picture to which it refers");
  group.Name("--display", "FILE.json", o.Projectors, "a display of projectors; a picture each");
  group.Name("--projector", "NAME", o.Projector,
    "the region of --warp, or the only projector of --display that is drawn");
  group.Number("--projector-gamma", "G", o.ProjectorGamma, Gammas, "gamma of the one of --warp");
}

void TakeWarp(Options& o)
{
  if (o.Warp.empty() && o.Projectors.empty())
  {
    if (!o.Projector.empty())
    {
      FailUsage("--projector goes with --warp or --display; leave it out");
    }
    return;
  }
  CheckWarp(o);
  o.ContentMap = o.Projection;
  o.ContentView = o.View;
  o.ContentView.Tilt = 0; // that of the view serves
  o.ContentView.Stereo = wfv::StereoOptions();
  const wfv::Projection& p = *wfv::FindProjection(o.Projection);
  if (p.Axis == wfv::Family::Azimuthal)
  {
    o.ContentView.Aspect = 1; // a square, which the rim touches
  }
  const wfv::ViewOptions usual;
  o.Projection = wfv::SampledProjection().Name;
  o.View.Lens = usual.Lens;
  o.View.Measured = usual.Measured;
  o.View.HorizontalFov = usual.HorizontalFov;
  o.View.VerticalFov = usual.VerticalFov;
}
}
