// SPDX-License-Identifier: BSD-3-Clause
// widefov-viewer: a window into VTK data in wide and non-planar projections.
#include "Loader.h"
#include "Pictures/DirectionMapFile.h"
#include "Pictures/Info.h"
#include "Pictures/Listing.h"
#include "Pictures/SkyPicture.h"
#include "StateLog.h"
#include "System/Display.h"
#include "System/Program.h"
#include "System/StandardInput.h"
#include "Text/Messages.h"
#include "Viewer.h"
#include "ViewerOptions.h"
#include "Viewing/Choices.h"
#include "Viewing/Room.h"
#include "Wall.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace
{
using namespace widefov;

int Run(int argc, char** argv)
{
  ViewerOptions options;
  if (const std::optional<int> done = ParseViewerOptions(argc, argv, options))
  {
    return *done;
  }
  const std::string told = ListingText(options.Picture) + InfoText(options.Picture);
  if (!told.empty())
  {
    Print(told);
    return ExitDone;
  }
  LoadDirectionMap(options.Picture);
  LoadSky(options.Picture);
  Room room(options.Picture, options.PoseRate, options.PoseOnce);
  options.Picture = room.GetGiven();
  const std::vector<std::string> files = options.Picture.Files;
  const StandardInput input(options.Picture.Files);
  options.Asked = options.Picture;
  options.HasStandardInput = files != options.Picture.Files;
  std::optional<Loaded> scene;
  if (options.HasStandardInput || !TakesLong(options.Picture))
  {
    scene = LoadFitted(options.Picture, true); // what is wrong is said before a window opens
  }
  const DisplayConnection display;
  StateLog log(options.Log);
  const QuietStandardError quiet;
  Wall windows(options, room.See(options.Picture));
  if (ShowsEyesInTurn(options.Picture) && !windows.HasBuffersForBoth())
  {
    Say("warning: there is no window with a buffer for each eye here; their pictures are shown in "
        "turn by software, which shutter glasses may not keep in step with");
  }
  Viewer(options, std::move(scene), room, windows, log).Run();
  return ExitDone;
}
}

int main(int argc, char** argv)
{
  return RunProgram("widefov-viewer", [=] { return Run(argc, argv); });
}
