// SPDX-License-Identifier: BSD-3-Clause
// widefov-viewer: a window into VTK data in wide and non-planar projections.
#include "CameraSetup.h"
#include "Choices.h"
#include "DirectionMapFile.h"
#include "Display.h"
#include "EyeDistance.h"
#include "FirstView.h"
#include "Info.h"
#include "Listing.h"
#include "LoadScene.h"
#include "Messages.h"
#include "Program.h"
#include "Room.h"
#include "SkyPicture.h"
#include "StandardInput.h"
#include "StateLog.h"
#include "Viewer.h"
#include "ViewerOptions.h"
#include "Wall.h"

namespace
{
using namespace widefov;

std::string TitleOf(const Options& options)
{
  std::string what = options.Scene;
  for (const std::string& file : options.Files)
  {
    what += (what.empty() ? "" : " ") + file;
  }
  return "widefov-viewer: " + what;
}

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
  Room room(options);
  options.Picture = room.GetGiven();
  const StandardInput input(options.Picture.Files);
  const Scene scene = LoadScene(options.Picture);
  ChooseView(options.Picture, scene);
  MakePose(scene, options.Picture); // complains before a window is opened
  FitEyes(options.Picture, scene);
  const DisplayConnection display;
  StateLog log(options.Log);
  const QuietStandardError quiet;
  Wall windows(options, room.See(options.Picture), scene, TitleOf(options.Picture));
  if (ShowsEyesInTurn(options.Picture) && !windows.HasBuffersForBoth())
  {
    Say("warning: there is no window with a buffer for each eye here; their pictures are shown in "
        "turn by software, which shutter glasses may not keep in step with");
  }
  Viewer(options, scene, room, windows, log).Run();
  return ExitDone;
}
}

int main(int argc, char** argv)
{
  return RunProgram("widefov-viewer", [=] { return Run(argc, argv); });
}
