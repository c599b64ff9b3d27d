// SPDX-License-Identifier: BSD-3-Clause
#include "JpegXmp.h"

#include "GPano.h"
#include "Messages.h"

#include <vtksys/Base64.h>
#include <vtksys/MD5.h>

#include <algorithm>
#include <cctype>

namespace widefov
{
namespace
{
const std::string PacketName = std::string("http://ns.adobe.com/xap/1.0/") + '\0';
const std::string ExtensionName = std::string("http://ns.adobe.com/xmp/extension/") + '\0';

// A segment's length is two bytes and counts itself.
constexpr std::size_t LongestSegment = 65533;

// Of an extension in one segment: less than is left behind its name, its checksum and two numbers.
constexpr std::size_t LongestPiece = 65000;

std::string BigEndian(std::size_t value, int bytes)
{
  std::string text;
  for (int shift = 8 * (bytes - 1); shift >= 0; shift -= 8)
  {
    text += static_cast<char>(value >> shift & 0xff);
  }
  return text;
}

// An application segment of number 1, which XMP shares with EXIF.
std::string Segment(const std::string& data)
{
  if (data.size() > LongestSegment)
  {
    Fail("the metadata of the picture are too long for JPEG; choose another format");
  }
  return std::string("\xFF\xE1") + BigEndian(data.size() + 2, 2) + data;
}

// By which a packet and its extension know each other: MD5, 32 digits.
std::string Checksum(const std::string& text)
{
  vtksysMD5* const md5 = vtksysMD5_New();
  vtksysMD5_Initialize(md5);
  vtksysMD5_Append(
    md5, reinterpret_cast<const unsigned char*>(text.data()), static_cast<int>(text.size()));
  std::string digits(32, '0');
  vtksysMD5_FinalizeHex(md5, &digits[0]);
  vtksysMD5_Delete(md5);
  std::transform(digits.begin(), digits.end(), digits.begin(),
    [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return digits;
}

std::string ExtensionSegments(const std::string& extension)
{
  std::string all;
  const std::string head = ExtensionName + Checksum(extension) + BigEndian(extension.size(), 4);
  for (std::size_t at = 0; at < extension.size(); at += LongestPiece)
  {
    all += Segment(head + BigEndian(at, 4) + extension.substr(at, LongestPiece));
  }
  return all;
}

// Where the segment that begins at `at` ends; the size where it is none with a length.
std::size_t EndOfSegment(const std::vector<unsigned char>& jpeg, std::size_t at)
{
  const bool segment =
    at + 4 <= jpeg.size() && jpeg[at] == 0xff && jpeg[at + 1] >= 0xe0 && jpeg[at + 1] <= 0xef;
  return segment ? at + 2 + (std::size_t(jpeg[at + 2]) << 8) + jpeg[at + 3] : jpeg.size();
}

// Takes away packets that the encoder wrote.
void RemovePackets(std::vector<unsigned char>& jpeg)
{
  std::size_t at = 2;
  while (EndOfSegment(jpeg, at) < jpeg.size())
  {
    const std::size_t end = EndOfSegment(jpeg, at);
    const auto first = jpeg.begin() + static_cast<std::ptrdiff_t>(at);
    const auto last = jpeg.begin() + static_cast<std::ptrdiff_t>(end);
    const bool packet = end - at > 4 + PacketName.size() && jpeg[at + 1] == 0xe1 &&
      std::equal(PacketName.begin(), PacketName.end(), first + 4);
    at = packet ? at : end;
    if (packet)
    {
      jpeg.erase(first, last);
    }
  }
}
}

void InsertJpegXmp(
  std::vector<unsigned char>& jpeg, const std::string& xmp, const std::string& extension)
{
  if (jpeg.size() < 4 || jpeg[0] != 0xff || jpeg[1] != 0xd8)
  {
    Fail("the JPEG encoder wrote no JPEG; choose another format");
  }
  RemovePackets(jpeg);
  const std::size_t first = EndOfSegment(jpeg, 2);
  const std::size_t at = first < jpeg.size() ? first : 2;
  const std::string all =
    Segment(PacketName + xmp) + (extension.empty() ? "" : ExtensionSegments(extension));
  jpeg.insert(jpeg.begin() + static_cast<std::ptrdiff_t>(at), all.begin(), all.end());
}

std::string Vr180Extension(const std::vector<unsigned char>& right)
{
  std::string text(right.size() / 3 * 4 + 8, '\0');
  text.resize(
    vtksysBase64_Encode(right.data(), right.size(), reinterpret_cast<unsigned char*>(&text[0]), 0));
  return "<x:xmpmeta xmlns:x=\"adobe:ns:meta/\">\n"
         "<rdf:RDF xmlns:rdf=\"http://www.w3.org/1999/02/22-rdf-syntax-ns#\">\n"
         "<rdf:Description rdf:about=\"\"\n"
         " xmlns:GImage=\"http://ns.google.com/photos/1.0/image/\"\n GImage:Data=\"" +
    text + "\"/>\n</rdf:RDF>\n</x:xmpmeta>";
}

std::string Vr180Xmp(int width, int height, const PanoramaInfo& info, const std::string& extension)
{
  return XmpPacket(GPanoText(width, height, info) +
    "\n xmlns:GImage=\"http://ns.google.com/photos/1.0/image/\""
    "\n xmlns:xmpNote=\"http://ns.adobe.com/xmp/note/\""
    "\n GImage:Mime=\"image/jpeg\"\n xmpNote:HasExtendedXMP=\"" +
    Checksum(extension) + "\"");
}
}
