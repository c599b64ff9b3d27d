// SPDX-License-Identifier: BSD-3-Clause
#include "ViewerOptions.h"

#include "Options/FieldsOfView.h"
#include "Options/OptionCheck.h"
#include "Options/OptionGroup.h"
#include "Options/ParseOptions.h"
#include "Options/PresetChoice.h"
#include "Options/Settings.h"
#include "System/OutputFiles.h"
#include "Text/Messages.h"
#include "Viewing/Choices.h"
#include "Viewing/Keys.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>

namespace widefov
{
namespace
{
// What fits most screens, in the proportions of the whole sphere; pixels.
constexpr int MostWindows = 16; // of a row or a column
constexpr std::array<int, 2> WindowSize{ { 1024, 512 } };

// The keys in their columns: of a footer CLI11 makes paragraphs since 2.5.
class KeysBelow : public CLI::Formatter
{
public:
  std::string make_help(
    const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override
  {
    std::string text = CLI::Formatter::make_help(app, std::move(name), mode);
    text.erase(text.find_last_not_of('\n') + 1); // each version ends with lines of its own
    return text + "\n\nKeys and mouse:\n" + HelpText() + "\n";
  }
};

void DeclareWindow(CLI::App& app, ViewerOptions& o)
{
  OptionGroup group(app, "Window");
  group.Flag("--full-screen", o.FullScreen, "begin with the whole screen");
  group.Integer("--monitor", o.Monitor, 0, 64, "for the full screen; 0 is the primary one");
  group.Add("--wall", "CxR", "1x1", "columns and rows of windows that show one picture",
    [&o](const std::string& option, const std::string& value) {
      const std::size_t cross = std::min(value.find('x'), value.size());
      const std::string rows = value.substr(std::min(cross + 1, value.size()));
      o.Wall[0] = ParseInteger(option, value.substr(0, cross), 1, MostWindows);
      o.Wall[1] = ParseInteger(option, rows, 1, MostWindows);
    });
  group.Number("--pose-rate", "HZ", o.PoseRate, { 0, 1000 },
    "poses of --pose a second; 0: as their times say");
  group.Flag("--pose-once", o.PoseOnce, "stay with the last pose instead of beginning anew");
  group.Number("--time-rate", "HZ", o.TimeRate, { 0.001, 1000 },
    "time steps a second, on average, that are played");
  group.Number("--update-rate", "HZ", o.UpdateRate, { 0, 1000 },
    "frames a second for which a moving picture is drawn smaller; 0: never");
  group.Flag("--no-text", o.NoText, "begin without the text on the picture");
  group.Flag("--panel", o.Panel, "begin with the panel");
  group.Name("--poses", "FILE", o.PoseList,
    "that key K adds a line to: eye, direction and up (widefov-viewer-poses.txt)");
  group.Name(
    "--session", "FILE", o.Session, "begin with what this file says, and write it by the key F3");
  group.Name("--log", "FILE", o.Log, "the state after each frame and click, a JSON object a line");
  group.Integer("--frames", o.Frames, 0, 1000000, "end after so many frames; 0: when closed");
}

// Goes before --config, and behind the command line.
void TakeSession(CLI::App& app, const ViewerOptions& o)
{
  if (o.Session.empty())
  {
    return;
  }
  std::error_code error;
  if (std::filesystem::exists(o.Session, error))
  {
    ApplySettings(app, ReadSettings(o.Session));
    return;
  }
  CheckWritable(o.Session);
  Say(o.Session + " is not there yet; the key F3 writes it");
}

void CheckRoom(const ViewerOptions& o)
{
  if (o.Picture.Poses.empty() && (o.PoseRate != 0 || o.PoseOnce))
  {
    FailUsage("--pose-rate and --pose-once go with --pose FILE; add it, or leave them out");
  }
  if (o.Picture.Screens.empty())
  {
    return;
  }
  if (o.Wall[0] * o.Wall[1] > 1)
  {
    FailUsage("--wall and --screens exclude each other: each screen has its own window");
  }
  if (o.Monitor > 0)
  {
    FailUsage("--screens and --monitor exclude each other: the windows take the monitors in turn");
  }
}

void CheckWall(ViewerOptions& o)
{
  const bool none = wfv::FindProjection(o.Picture.Projection) == nullptr; // lists are asked for
  if (none || o.Wall[0] * o.Wall[1] == 1)
  {
    return;
  }
  if (!CanBeTiled(o.Picture))
  {
    FailUsage("--wall is for wide projections drawn by this module, not for perspective and "
              "--technique cubemap; leave it out");
  }
  if (o.Picture.Part)
  {
    FailUsage("--wall and --borders exclude each other: windows of a wall show a whole picture");
  }
  if (o.Monitor > 0)
  {
    FailUsage("--wall and --monitor exclude each other: the windows take the monitors in turn");
  }
}
}

std::optional<int> ParseViewerOptions(int argc, char** argv, ViewerOptions& o)
{
  CLI::App app("VTK data in wide and non-planar projections, in a window.", "widefov-viewer");
  app.formatter(std::make_shared<KeysBelow>());
  FieldsOfView fov;
  o.Picture.Size = WindowSize;
  DeclareScene(app, o.Picture, fov);
  DeclareWindow(app, o);
  if (const std::optional<int> done = ParseCommandLine(app, argc, argv))
  {
    return done;
  }
  TakeSession(app, o);
  CompleteFromPreset(app, o.Picture, Target::Window);
  CheckScene(o.Picture, fov);
  CheckRoom(o);
  CheckWall(o);
  if (!FitsWindow(o.Picture))
  {
    FailUsage("--layout " + o.Picture.Layout + " is for files; take one that is one picture");
  }
  return std::nullopt;
}
}
