// SPDX-License-Identifier: BSD-3-Clause
#include "JpegXmp.h"

#include "GPano.h"
#include "Text/Messages.h"

#include <vtksys/Base64.h>
#include <vtksys/MD5.h>

#include <algorithm>
#include <cctype>

namespace widefov
{
namespace
{
const std::string ExtensionName = std::string("http://ns.adobe.com/xmp/extension/") + '\0';

// Of an extension in one segment: less than is left behind its name, its checksum and two numbers.
constexpr std::size_t LongestPiece = 65000;

// One that holds the data.
std::string Segment(const std::string& data)
{
  const std::string segment = wfvxmp::JpegSegment(data);
  if (segment.empty())
  {
    Fail("the metadata of the picture are too long for JPEG; choose another format");
  }
  return segment;
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
  const std::string head =
    ExtensionName + Checksum(extension) + wfvxmp::BigEndian(extension.size(), 4);
  for (std::size_t at = 0; at < extension.size(); at += LongestPiece)
  {
    all += Segment(head + wfvxmp::BigEndian(at, 4) + extension.substr(at, LongestPiece));
  }
  return all;
}
}

void InsertJpegXmp(
  std::vector<unsigned char>& jpeg, const std::string& xmp, const std::string& extension)
{
  const std::string all =
    Segment(wfvxmp::JpegPacketName + xmp) + (extension.empty() ? "" : ExtensionSegments(extension));
  if (!wfvxmp::InsertInJpeg(jpeg, all))
  {
    Fail("the JPEG encoder wrote no JPEG; choose another format");
  }
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
  return wfvxmp::XmpPacket(GPanoText(width, height, info) +
    "\n xmlns:GImage=\"http://ns.google.com/photos/1.0/image/\""
    "\n xmlns:xmpNote=\"http://ns.adobe.com/xmp/note/\""
    "\n GImage:Mime=\"image/jpeg\"\n xmpNote:HasExtendedXMP=\"" +
    Checksum(extension) + "\"");
}
}
