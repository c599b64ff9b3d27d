// SPDX-License-Identifier: BSD-3-Clause
#include "DirectionMapFile.h"

#include "Options/Displays.h"
#include "Options/LensMap.h"
#include "Projections/DirectionMap.h"
#include "System/CrashGuard.h"
#include "System/Progress.h"
#include "Text/Messages.h"
#include "Text/OptionValues.h"
#include "Warp.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <filesystem>

namespace widefov
{
namespace
{
std::string SizeText(int width, int height)
{
  return std::to_string(width) + "x" + std::to_string(height);
}

// The numbers of the channels with these names, or an empty list.
std::vector<int> FindChannels(const OIIO::ImageSpec& spec, const std::vector<std::string>& names)
{
  std::vector<int> numbers;
  for (const std::string& name : names)
  {
    const auto found = std::find(spec.channelnames.begin(), spec.channelnames.end(), name);
    if (found == spec.channelnames.end())
    {
      return {};
    }
    numbers.push_back(static_cast<int>(found - spec.channelnames.begin()));
  }
  return numbers;
}

std::vector<int> DirectionChannels(const std::string& path, const OIIO::ImageSpec& spec)
{
  for (const std::vector<std::string>& names :
    { std::vector<std::string>{ "X", "Y", "Z" }, std::vector<std::string>{ "R", "G", "B" } })
  {
    const std::vector<int> numbers = FindChannels(spec, names);
    if (!numbers.empty())
    {
      return numbers;
    }
  }
  std::string names;
  for (const std::string& name : spec.channelnames)
  {
    names += (names.empty() ? "" : ", ") + name;
  }
  Fail(path + " has the channels " + names +
    "; a direction map needs X, Y, Z (or R, G, B): x to the right, y up, z behind");
}

// Three numbers a pixel, the bottom row first.
std::vector<float> ReadDirections(
  const std::string& path, OIIO::ImageInput& input, const OIIO::ImageSpec& spec)
{
  const std::vector<int> channels = DirectionChannels(path, spec);
  const std::size_t stride = spec.channelnames.size();
  std::vector<float> all(stride * spec.width * spec.height);
  if (!input.read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, all.data()))
  {
    Fail(path + " cannot be read: " + input.geterror() + "; check the file");
  }
  std::vector<float> directions;
  directions.reserve(3 * static_cast<std::size_t>(spec.width) * spec.height);
  for (int row = spec.height - 1; row >= 0; row--)
  {
    for (int column = 0; column < spec.width; column++)
    {
      const float* const pixel =
        &all[stride * (static_cast<std::size_t>(row) * spec.width + column)];
      for (const int channel : channels)
      {
        directions.push_back(pixel[channel]);
      }
    }
  }
  return directions;
}

void TakeSize(Options& o, const std::string& path, const OIIO::ImageSpec& spec)
{
  if (o.HasSize && (o.Size[0] != spec.width || o.Size[1] != spec.height))
  {
    Fail(path + " is " + SizeText(spec.width, spec.height) + " pixels, the picture " +
      SizeText(o.Size[0], o.Size[1]) + ": a direction map has one direction a pixel; leave " +
      "--size out");
  }
  o.Size = { { spec.width, spec.height } };
  o.View.Aspect = double(spec.width) / spec.height;
}
}

namespace
{
// Of what needs no file; false: it does.
bool MakeDirectionMap(Options& o)
{
  if (o.UnevenLens)
  {
    const Progress progress("solving the lens of " + o.LensFile);
    o.View.Map = MakeLensMap(*o.UnevenLens, o.Size[0], o.Size[1]);
    return true;
  }
  const Display* const display = FindDisplay(o.DirectionMap);
  if (display)
  {
    o.View.Map = MakeDisplay(*display, o.Size[0], o.Size[1]);
  }
  return display != nullptr;
}
}

void LoadDirectionMap(Options& o)
{
  if (!o.Warp.empty())
  {
    LoadWarp(o);
  }
  if (MakeDirectionMap(o) || o.DirectionMap.empty())
  {
    return;
  }
  const std::string& path = o.DirectionMap;
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error))
  {
    Fail(path + " is not there, or no file; give a direction map as an OpenEXR image, or one of " +
      Join(DisplayNames()));
  }
  const Progress progress("reading " + path);
  const CrashGuard guard(path + " cannot be read: it is damaged; check the file");
  // (not by the file's name: all the readers would have a look at a file that is no image)
  const std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::create("openexr");
  OIIO::ImageSpec spec;
  if (!input || !input->open(path, spec))
  {
    Fail(path + " is no OpenEXR image; give a direction map as one");
  }
  TakeSize(o, path, spec);
  const std::vector<float> directions = ReadDirections(path, *input, spec);
  const std::string problem = wfv::DirectionMap::Check(spec.width, spec.height, directions);
  if (!problem.empty())
  {
    Fail(path + ": " + problem + "; check the file");
  }
  o.View.Map = std::make_shared<const wfv::DirectionMap>(spec.width, spec.height, directions);
}
}
