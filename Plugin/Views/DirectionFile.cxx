// SPDX-License-Identifier: BSD-3-Clause
#include "DirectionFile.h"

#include "Projections/DirectionMap.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>

#include <array>
#include <filesystem>
#include <stdexcept>
#include <vector>

namespace wfvplugin
{
namespace
{
using Names = std::array<const char*, 3>;

Names ChannelsOf(const Imf::ChannelList& channels)
{
  for (const Names& names : { Names{ { "X", "Y", "Z" } }, Names{ { "R", "G", "B" } } })
  {
    if (channels.findChannel(names[0]) && channels.findChannel(names[1]) &&
      channels.findChannel(names[2]))
    {
      return names;
    }
  }
  throw std::runtime_error("it needs the channels X, Y, Z (or R, G, B)");
}

// Three numbers a pixel, the bottom row first.
std::vector<float> ReadNumbers(Imf::InputFile& file, int width, int height)
{
  const Imath::Box2i window = file.header().dataWindow();
  std::vector<float> top(3 * static_cast<std::size_t>(width) * height);
  constexpr std::size_t PixelBytes = 3 * sizeof(float);
  const std::size_t rowBytes = PixelBytes * width;
  Imf::FrameBuffer buffer;
  const Names names = ChannelsOf(file.header().channels());
  for (int c = 0; c < 3; c++)
  {
    buffer.insert(
      names[c], Imf::Slice::Make(Imf::FLOAT, top.data() + c, window, PixelBytes, rowBytes));
  }
  file.setFrameBuffer(buffer);
  file.readPixels(window.min.y, window.max.y);
  std::vector<float> bottom;
  bottom.reserve(top.size());
  for (int row = height - 1; row >= 0; row--)
  {
    const auto begin = top.begin() + static_cast<std::ptrdiff_t>(3) * width * row;
    bottom.insert(bottom.end(), begin, begin + static_cast<std::ptrdiff_t>(3) * width);
  }
  return bottom;
}
}

std::shared_ptr<const wfv::DirectionMap> ReadDirectionFile(const std::string& path)
{
  try
  {
    if (!std::filesystem::is_regular_file(path))
    {
      throw std::runtime_error("it is not there, or no file");
    }
    Imf::InputFile file(path.c_str());
    const Imath::V2i size = file.header().dataWindow().size() + Imath::V2i(1);
    const std::vector<float> numbers = ReadNumbers(file, size.x, size.y);
    const std::string problem = wfv::DirectionMap::Check(size.x, size.y, numbers);
    if (!problem.empty())
    {
      throw std::runtime_error(problem);
    }
    return std::make_shared<const wfv::DirectionMap>(size.x, size.y, numbers);
  }
  catch (const std::exception& e)
  {
    throw std::runtime_error(path + " is no direction map: " + e.what());
  }
}
}
