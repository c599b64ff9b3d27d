// SPDX-License-Identifier: BSD-3-Clause
#include "PanoramaXmp.h"

#include "vtk_zlib.h"

#include <cmath>
#include <cstring>
#include <sstream>

namespace wfvplugin
{
namespace
{
void AppendBigEndian(std::string& bytes, unsigned long value, int count)
{
  for (int shift = 8 * (count - 1); shift >= 0; shift -= 8)
  {
    bytes += static_cast<char>(value >> shift & 0xff);
  }
}

void Insert(std::vector<unsigned char>& file, std::size_t at, const std::string& bytes)
{
  file.insert(file.begin() + static_cast<std::ptrdiff_t>(at), bytes.begin(), bytes.end());
}
}

std::string PanoramaXmp(const Panorama& p)
{
  const long fullWidth = std::lround(p.Width * 360 / p.HorizontalFov);
  const long fullHeight = std::lround(p.Height * 180 / p.VerticalFov);
  std::ostringstream xmp;
  const auto field = [&xmp](const char* name, const auto& value) {
    xmp << "\n GPano:" << name << "=\"" << value << "\"";
  };
  xmp << "<?xpacket begin=\"\xEF\xBB\xBF\" id=\"W5M0MpCehiHzreSzNTczkc9d\"?>\n"
         "<x:xmpmeta xmlns:x=\"adobe:ns:meta/\">\n"
         "<rdf:RDF xmlns:rdf=\"http://www.w3.org/1999/02/22-rdf-syntax-ns#\">\n"
         "<rdf:Description rdf:about=\"\"\n"
         " xmlns:GPano=\"http://ns.google.com/photos/1.0/panorama/\"";
  field("ProjectionType", "equirectangular");
  field("UsePanoramaViewer", "True");
  field("CroppedAreaImageWidthPixels", p.Width);
  field("CroppedAreaImageHeightPixels", p.Height);
  field("FullPanoWidthPixels", fullWidth);
  field("FullPanoHeightPixels", fullHeight);
  field("CroppedAreaLeftPixels", (fullWidth - p.Width) / 2);
  field("CroppedAreaTopPixels", (fullHeight - p.Height) / 2);
  field("PoseHeadingDegrees", 0);
  field("PosePitchDegrees", p.Pitch);
  field("PoseRollDegrees", 0);
  xmp << "/>\n</rdf:RDF>\n</x:xmpmeta>\n<?xpacket end=\"w\"?>";
  return xmp.str();
}

bool InsertXmpInPng(std::vector<unsigned char>& file, const std::string& xmp)
{
  constexpr std::size_t HeaderEnd = 8 + 4 + 4 + 13 + 4; // signature and the IHDR chunk
  if (file.size() < HeaderEnd || std::memcmp(file.data() + 12, "IHDR", 4) != 0)
  {
    return false;
  }
  // keyword, not compressed, no language, no translated keyword
  const std::string data = "iTXtXML:com.adobe.xmp" + std::string(5, '\0') + xmp;
  std::string chunk;
  AppendBigEndian(chunk, data.size() - 4, 4);
  chunk += data;
  AppendBigEndian(chunk,
    crc32(0, reinterpret_cast<const Bytef*>(data.data()), static_cast<uInt>(data.size())), 4);
  Insert(file, HeaderEnd, chunk);
  return true;
}

bool InsertXmpInJpeg(std::vector<unsigned char>& file, const std::string& xmp)
{
  constexpr std::size_t MostBytes = 65535; // that a segment's length can say
  const std::string data = std::string("http://ns.adobe.com/xap/1.0/") + '\0' + xmp;
  if (file.size() < 6 || file[0] != 0xff || file[1] != 0xd8 || data.size() + 2 > MostBytes)
  {
    return false;
  }
  std::size_t at = 2;
  if (file[2] == 0xff && file[3] == 0xe0) // a JFIF segment stays the first
  {
    at += 2 + 256 * std::size_t(file[4]) + file[5];
  }
  if (at > file.size())
  {
    return false;
  }
  std::string segment("\xff\xe1");
  AppendBigEndian(segment, data.size() + 2, 2);
  Insert(file, at, segment + data);
  return true;
}
}
