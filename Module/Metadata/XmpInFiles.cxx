// SPDX-License-Identifier: BSD-3-Clause
#include "XmpInFiles.h"

#include <zlib.h>

#include <algorithm>
#include <cstring>

namespace wfvxmp
{
const std::string JpegPacketName = std::string("http://ns.adobe.com/xap/1.0/") + '\0';

std::string BigEndian(std::size_t value, int bytes)
{
  std::string text;
  for (int shift = 8 * (bytes - 1); shift >= 0; shift -= 8)
  {
    text += static_cast<char>(value >> shift & 0xff);
  }
  return text;
}

// Length, type, data, checksum over type and data.
Bytes PngChunk(const std::string& xmp)
{
  // keyword, not compressed, no language, no translated keyword
  const std::string data = std::string("XML:com.adobe.xmp") + std::string(5, '\0') + xmp;
  const std::string typed = "iTXt" + data;
  const uLong checksum =
    crc32(0, reinterpret_cast<const Bytef*>(typed.data()), static_cast<uInt>(typed.size()));
  const std::string chunk = BigEndian(data.size(), 4) + typed + BigEndian(checksum, 4);
  return { chunk.begin(), chunk.end() };
}

bool InsertInPng(Bytes& png, const Bytes& chunk)
{
  if (png.size() < PngHeaderEnd || std::memcmp(png.data() + 12, "IHDR", 4) != 0)
  {
    return false;
  }
  png.insert(png.begin() + PngHeaderEnd, chunk.begin(), chunk.end());
  return true;
}

std::string JpegSegment(const std::string& data)
{
  constexpr std::size_t LongestSegment = 65533; // its length is two bytes and counts itself
  return data.size() > LongestSegment
    ? std::string()
    : std::string("\xFF\xE1") + BigEndian(data.size() + 2, 2) + data;
}

namespace
{
// Where the segment that begins at `at` ends; the size where it is none with a length.
std::size_t EndOfSegment(const Bytes& jpeg, std::size_t at)
{
  const bool segment =
    at + 4 <= jpeg.size() && jpeg[at] == 0xff && jpeg[at + 1] >= 0xe0 && jpeg[at + 1] <= 0xef;
  return segment ? at + 2 + (std::size_t(jpeg[at + 2]) << 8) + jpeg[at + 3] : jpeg.size();
}

void RemovePackets(Bytes& jpeg)
{
  std::size_t at = 2;
  while (EndOfSegment(jpeg, at) < jpeg.size())
  {
    const std::size_t end = EndOfSegment(jpeg, at);
    const auto first = jpeg.begin() + static_cast<std::ptrdiff_t>(at);
    const auto last = jpeg.begin() + static_cast<std::ptrdiff_t>(end);
    const bool packet = end - at > 4 + JpegPacketName.size() && jpeg[at + 1] == 0xe1 &&
      std::equal(JpegPacketName.begin(), JpegPacketName.end(), first + 4,
        [](char a, unsigned char b) { return static_cast<unsigned char>(a) == b; });
    at = packet ? at : end;
    if (packet)
    {
      jpeg.erase(first, last);
    }
  }
}
}

bool InsertInJpeg(Bytes& jpeg, const std::string& segments)
{
  if (jpeg.size() < 4 || jpeg[0] != 0xff || jpeg[1] != 0xd8)
  {
    return false;
  }
  RemovePackets(jpeg);
  const std::size_t first = EndOfSegment(jpeg, 2);
  const std::size_t at = first < jpeg.size() ? first : 2;
  jpeg.insert(jpeg.begin() + static_cast<std::ptrdiff_t>(at), segments.begin(), segments.end());
  return true;
}
}
