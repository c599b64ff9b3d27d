// SPDX-License-Identifier: BSD-3-Clause
#include "RoomOptions.h"

#include "StereoChoice.h"
#include "Text/Messages.h"

namespace widefov
{
void DeclareRoom(CLI::App& app, Options& o)
{
  OptionGroup group(app, "Room");
  group.Name("--screens", "FILE.pvx", o.Screens,
    "flat screens of a wall or CAVE, as ParaView describes them; a picture each");
  group.Name("--pose", "FILE", o.Poses, "recorded head poses; a numbered picture each");
  group.Number("--room-scale", "S", o.RoomScale, { 1 / LargestRoomScale, LargestRoomScale },
    "scene units a unit of the screens and poses");
}

bool HasRoom(const Options& o)
{
  return !o.Screens.empty() || !o.Poses.empty();
}

void CompleteRoom(Options& o, const FieldsOfView& fov)
{
  if (!HasRoom(o) && o.RoomScale != 1)
  {
    FailUsage("--room-scale goes with --screens and --pose; leave it out");
  }
  if (HasRoom(o) && !o.Aov.empty())
  {
    FailUsage("--aov is for one picture, not for those of --screens and --pose; leave it out");
  }
  if (o.Screens.empty())
  {
    return;
  }
  if (ShowsCube(o))
  {
    return; // the volume is behind the screen, whatever its map
  }
  if (o.HasProjection && o.Projection != "perspective")
  {
    FailUsage("--screens are flat and show the projection perspective; leave --projection out");
  }
  o.Projection = "perspective";
  if (fov.Horizontal || fov.Vertical || fov.Round || !fov.Lens.empty() || o.View.Tilt != 0 ||
    !o.LensFile.empty() || !o.Circle.empty())
  {
    FailUsage("what --screens show follows from their corners; leave --hfov, --vfov, --fov, "
              "--lens, --lens-file, --circle "
              "and --tilt out");
  }
}
}
