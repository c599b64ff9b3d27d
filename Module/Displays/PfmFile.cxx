// SPDX-License-Identifier: BSD-3-Clause
// Source: Paul Debevec, "Portable FloatMap Image Format"; MPCDI 2.0, geometry warp files.
#include "FileText.h"
#include "Readers.h"

#include <algorithm>
#include <cstring>

namespace wfv::displays
{
namespace
{
struct Header
{
  std::size_t Width = 0;
  std::size_t Height = 0;
  bool BigEndian = false;
  std::size_t End = 0; // bytes
};

// Takes one word and the one blank behind it.
std::string Word(const std::string& bytes, std::size_t& at)
{
  constexpr std::size_t longest = 32; // bytes
  const std::size_t end = bytes.find_first_of(" \t\r\n", at);
  if (end == std::string::npos || end - at > longest)
  {
    return "";
  }
  const std::string word = bytes.substr(at, end - at);
  const bool twoBytes = bytes.compare(end, 2, "\r\n") == 0;
  at = end + (twoBytes ? 2 : 1);
  return word;
}

Header ReadHeader(const std::string& path, const std::string& bytes)
{
  Header header;
  if (Word(bytes, header.End) != "PF")
  {
    throw FileError(path + " does not begin with PF: it is no PFM of three channels");
  }
  double scale = 0;
  std::array<double, 2> sizes{};
  const std::string width = Word(bytes, header.End);
  const std::string height = Word(bytes, header.End);
  const std::string last = Word(bytes, header.End);
  const bool numbers =
    Numbers(width).Next(sizes[0]) && Numbers(height).Next(sizes[1]) && Numbers(last).Next(scale);
  header.Width = CountOf(sizes[0]);
  header.Height = CountOf(sizes[1]);
  if (!numbers || header.Width < 2 || header.Height < 2 || !(scale < 0 || scale > 0) ||
    header.Width * header.Height > LargestCount)
  {
    throw FileError(path + " has no width, height (2 at least) and scale behind PF");
  }
  header.BigEndian = scale > 0;
  return header;
}

float Number(const char* at, bool bigEndian)
{
  std::uint32_t bits = 0;
  for (int i = 0; i < 4; i++)
  {
    const auto byte = static_cast<unsigned char>(at[bigEndian ? i : 3 - i]);
    bits = bits << 8 | byte;
  }
  float number = 0;
  std::memcpy(&number, &bits, sizeof number);
  return number;
}
}

Raster ReadPfm(const std::string& path, const std::string& bytes)
{
  const Header header = ReadHeader(path, bytes);
  const std::size_t count = header.Width * header.Height;
  constexpr std::size_t stride = 3 * sizeof(float);
  if (bytes.size() < header.End + stride * count)
  {
    throw FileError(path + " has " + std::to_string((bytes.size() - header.End) / stride) + " of " +
      std::to_string(count) + " pixels: it is cut; get the whole file");
  }
  Raster raster{ static_cast<int>(header.Width), static_cast<int>(header.Height), {} };
  raster.Values.reserve(count);
  for (std::size_t i = 0; i < count; i++)
  {
    const char* const at = bytes.data() + header.End + stride * i;
    raster.Values.emplace_back(Number(at, header.BigEndian),
      Number(at + sizeof(float), header.BigEndian),
      Number(at + 2 * sizeof(float), header.BigEndian));
  }
  return raster;
}

namespace
{
// Share of the cells between pixels that may be mirrored beside the others: noise of a camera that
// measured them. More is a fold.
constexpr double NoiseShare = 0.01;

// Removes empty pixels. Programs write them as NaN or as zeros. A single zero may be a corner.
void DropEmpty(Calibration& calibration)
{
  const bool flat = calibration.What == Shows::Picture;
  const auto isZero = [flat](const vec3& v) { return v.x == 0 && v.y == 0 && (flat || v.z == 0); };
  std::vector<vec3>& values = calibration.Pixels.Values;
  const auto zeros = std::count_if(values.begin(), values.end(), isZero);
  for (vec3& v : values)
  {
    v.z = flat ? 0 : v.z;
    if ((zeros > 1 && isZero(v)) || !std::isfinite(v.x + v.y + v.z))
    {
      v = vec3(std::nan(""));
    }
  }
}

// Cells between four pixels that show the picture as it is, and mirrored.
std::array<std::size_t, 2> CountCells(const Raster& pixels)
{
  std::array<std::size_t, 2> counts{ 0, 0 };
  for (int y = 0; y + 1 < pixels.Height; y++)
  {
    for (int x = 0; x + 1 < pixels.Width; x++)
    {
      const vec3* const at = &pixels.Values[static_cast<std::size_t>(y) * pixels.Width + x];
      const vec3 right = at[1] - at[0];
      const vec3 up = at[pixels.Width] - at[0];
      const double area = right.x * up.y - right.y * up.x;
      counts[0] += area > 0 ? 1 : 0; // NaN is neither
      counts[1] += area < 0 ? 1 : 0;
    }
  }
  return counts;
}
}

void CheckPixels(const std::string& path, Calibration& calibration)
{
  DropEmpty(calibration);
  const std::vector<vec3>& values = calibration.Pixels.Values;
  if (std::all_of(values.begin(), values.end(), [](const vec3& v) { return std::isnan(v.x); }))
  {
    throw FileError(path + ": no pixel shows anything; calibrate again");
  }
  if (calibration.What != Shows::Picture)
  {
    return;
  }
  const std::array<std::size_t, 2> counts = CountCells(calibration.Pixels);
  const std::size_t fewer = std::min(counts[0], counts[1]);
  const std::string folded = path + ": " + std::to_string(fewer) + " of " +
    std::to_string(counts[0] + counts[1]) + " cells between pixels are mirrored";
  if (double(fewer) > NoiseShare * double(counts[0] + counts[1]))
  {
    throw FileError(folded + ": the map folds; calibrate again");
  }
  if (fewer > 0)
  {
    calibration.Notes.push_back(folded + ", as noise of a measurement is");
  }
  if (counts[1] > counts[0])
  {
    calibration.Notes.push_back(path +
      " shows the picture mirrored: either the projector does, or " +
      "the file has its upper row first, against the rule of PFM");
  }
}

Calibration ReadPfmWarp(const std::string& path, const std::string& bytes)
{
  Calibration calibration;
  calibration.Pixels = ReadPfm(path, bytes);
  calibration.Size = { { calibration.Pixels.Width, calibration.Pixels.Height } };
  CheckPixels(path, calibration);
  return calibration;
}
}
