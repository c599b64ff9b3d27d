// SPDX-License-Identifier: BSD-3-Clause
#include "ViewerOptions.h"

#include "Keys.h"
#include "OptionCheck.h"
#include "OptionGroup.h"

namespace widefov
{
namespace
{
// What fits most screens, in the proportions of the whole sphere; pixels.
constexpr std::array<int, 2> WindowSize{ { 1024, 512 } };

void DeclareWindow(CLI::App& app, ViewerOptions& o)
{
  OptionGroup group(app, "Window");
  group.Flag("--full-screen", o.FullScreen, "begin with the whole screen");
  group.Integer("--monitor", o.Monitor, 0, 64, "for the full screen; 0 is the primary one");
  group.Flag("--no-text", o.NoText, "begin without the text on the picture");
  group.Name("--log", "FILE", o.Log, "the state after each frame and click, a JSON object a line");
  group.Integer("--frames", o.Frames, 0, 1000000, "end after so many frames; 0: when closed");
}
}

std::optional<int> ParseViewerOptions(int argc, char** argv, ViewerOptions& o)
{
  CLI::App app("VTK data in wide and non-planar projections, in a window.", "widefov-viewer");
  app.footer("Keys and mouse:\n" + HelpText());
  FieldsOfView fov;
  o.Picture.Size = WindowSize;
  DeclareScene(app, o.Picture, fov);
  DeclareWindow(app, o);
  if (const std::optional<int> done = ParseCommandLine(app, argc, argv))
  {
    return done;
  }
  o.Picture.HasSize = app.count("--size") > 0;
  CheckScene(o.Picture, fov);
  return std::nullopt;
}
}
