// SPDX-License-Identifier: BSD-3-Clause
#include "Warp.h"

#include "Displays/DisplayFile.h"
#include "Projections/DirectionMap.h"
#include "System/Progress.h"
#include "System/InputFiles.h"
#include "Text/Messages.h"

#include <algorithm>
#include <cmath>

namespace widefov
{
namespace
{
namespace displays = wfv::displays;

// Calls what reads files, whose errors end the program.
template <typename Read>
auto Reading(const std::string& path, const Read& read)
{
  const Progress progress("reading " + path);
  try
  {
    return read();
  }
  catch (const displays::FileError& error)
  {
    Fail(error.what());
  }
}

void TakeTable(
  Options& o, const std::string& path, const displays::Table& table, double gamma, wfv::vec3 eye)
{
  const std::vector<float> directions = displays::DirectionsFrom(table, eye);
  const std::string problem = wfv::DirectionMap::Check(table.Width, table.Height, directions);
  if (!problem.empty())
  {
    Fail(path + ": " + problem + "; calibrate again");
  }
  o.Size = { { table.Width, table.Height } };
  o.View.Aspect = double(table.Width) / table.Height;
  o.View.Map = std::make_shared<const wfv::DirectionMap>(table.Width, table.Height, directions);
  auto light = std::make_shared<ProjectorLight>();
  light->Brightness = table.Brightness;
  light->Lift = table.Lift;
  light->Gamma = gamma;
  o.Light = light;
}

void SayNotes(const std::vector<std::string>& notes)
{
  for (const std::string& note : notes)
  {
    Say("warning: " + note);
  }
}

displays::Table TableOf(const Options& o)
{
  const displays::Calibration calibration = displays::ReadCalibration(o.Warp, o.Projector);
  SayNotes(calibration.Notes);
  const std::array<int, 2> size = o.HasSize ? o.Size : calibration.Size;
  if (size[0] == 0)
  {
    throw displays::FileError(o.Warp + " says no pixels; give --size WIDTHxHEIGHT");
  }
  const displays::Content content =
    displays::ContentOfView(*wfv::FindProjection(o.ContentMap), o.ContentView);
  return displays::MakeTable(calibration, size[0], size[1], content, o.ProjectorGamma);
}
}

void LoadWarp(Options& o)
{
  const displays::Table table = Reading(o.Warp, [&o] { return TableOf(o); });
  TakeTable(o, o.Warp, table, o.ProjectorGamma, wfv::vec3(0));
}

std::vector<Options> LoadProjectors(const Options& o)
{
  std::vector<std::string> notes;
  const auto [display, tables] = Reading(o.Projectors, [&] {
    displays::DisplayFile file = displays::ReadDisplay(o.Projectors);
    std::vector<displays::Table> all = displays::MakeTables(file, notes);
    return std::make_pair(std::move(file), std::move(all));
  });
  SayNotes(notes);
  for (const displays::DisplayProjector& projector : display.Projectors)
  {
    NoteInput(projector.Calibration);
    NoteInput(projector.Mask);
  }
  std::vector<Options> projectors;
  for (std::size_t i = 0; i < tables.size(); i++)
  {
    const displays::DisplayProjector& projector = display.Projectors[i];
    if (o.Projector.empty() || o.Projector == projector.Name)
    {
      projectors.push_back(o);
      projectors.back().ProjectorName = projector.Name;
      TakeTable(projectors.back(), o.Projectors, tables[i], projector.Gamma, display.Eye);
    }
  }
  if (projectors.empty())
  {
    Fail(o.Projectors + " has no projector " + o.Projector + "; look at its names");
  }
  return projectors;
}

Options WithProjector(const Options& options, const Options& projector)
{
  Options o = options;
  o.ProjectorName = projector.ProjectorName;
  o.Size = projector.Size;
  o.View.Aspect = projector.View.Aspect;
  o.View.Map = projector.View.Map;
  o.Light = projector.Light;
  return o;
}

void ApplyLight(const Options& o, Picture& picture, int firstRow)
{
  if (!o.Light)
  {
    return;
  }
  const ProjectorLight& light = *o.Light;
  std::array<double, 256> linear{};
  for (int value = 0; value < 256; value++)
  {
    linear[value] = std::pow(value / 255., light.Gamma);
  }
  for (int y = 0; y < picture.Height; y++)
  {
    const std::size_t row = static_cast<std::size_t>(o.Size[1] - 1 - firstRow - y) * o.Size[0];
    for (int x = 0; x < picture.Width; x++)
    {
      const double brightness = light.Brightness[row + x];
      const double lift = light.Lift.empty() ? 0 : light.Lift[row + x];
      unsigned char* const pixel =
        &picture.Rgb[3 * (static_cast<std::size_t>(y) * picture.Width + x)];
      for (int c = 0; c < 3 && (brightness != 1 || lift != 0); c++)
      {
        const double sent =
          std::pow(std::clamp(brightness * linear[pixel[c]] + lift, 0., 1.), 1 / light.Gamma);
        pixel[c] = static_cast<unsigned char>(std::lround(255 * sent));
      }
    }
  }
}
}
