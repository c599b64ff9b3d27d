// SPDX-License-Identifier: BSD-3-Clause
#include "GPano.h"

#include "Messages.h"

#include <zlib.h>

#include <cmath>
#include <cstring>

namespace widefov
{
namespace
{
void AppendBigEndian(std::vector<unsigned char>& bytes, unsigned long value)
{
  for (int shift = 24; shift >= 0; shift -= 8)
  {
    bytes.push_back(static_cast<unsigned char>(value >> shift & 0xff));
  }
}

// Length, type, data, checksum over type and data.
std::vector<unsigned char> MakeChunk(const std::string& type, const std::string& data)
{
  std::vector<unsigned char> chunk;
  AppendBigEndian(chunk, data.size());
  chunk.insert(chunk.end(), type.begin(), type.end());
  chunk.insert(chunk.end(), data.begin(), data.end());
  const uLong checksum = crc32(0, chunk.data() + 4, static_cast<uInt>(type.size() + data.size()));
  AppendBigEndian(chunk, checksum);
  return chunk;
}
}

std::vector<GPanoField> GPanoFields(int width, int height, const PanoramaInfo& info)
{
  const long fullWidth = std::lround(width * 360 / info.HorizontalFov);
  const long fullHeight = std::lround(height * 180 / info.VerticalFov);
  const auto text = [](long value) { return std::to_string(value); };
  return { { "ProjectionType", "equirectangular" }, { "UsePanoramaViewer", "True" },
    { "CroppedAreaImageWidthPixels", text(width) },
    { "CroppedAreaImageHeightPixels", text(height) }, { "FullPanoWidthPixels", text(fullWidth) },
    { "FullPanoHeightPixels", text(fullHeight) },
    { "CroppedAreaLeftPixels", text((fullWidth - width) / 2) },
    { "CroppedAreaTopPixels", text((fullHeight - height) / 2) }, { "PoseHeadingDegrees", "0" },
    { "PosePitchDegrees", "0" }, { "PoseRollDegrees", "0" } };
}

std::string XmpPacket(const std::string& description)
{
  return "<?xpacket begin=\"\xEF\xBB\xBF\" id=\"W5M0MpCehiHzreSzNTczkc9d\"?>\n"
         "<x:xmpmeta xmlns:x=\"adobe:ns:meta/\">\n"
         "<rdf:RDF xmlns:rdf=\"http://www.w3.org/1999/02/22-rdf-syntax-ns#\">\n"
         "<rdf:Description rdf:about=\"\"\n" +
    description + "/>\n</rdf:RDF>\n</x:xmpmeta>\n<?xpacket end=\"w\"?>";
}

std::string GPanoText(int width, int height, const PanoramaInfo& info)
{
  std::string text = " xmlns:GPano=\"http://ns.google.com/photos/1.0/panorama/\"";
  for (const GPanoField& field : GPanoFields(width, height, info))
  {
    text += "\n GPano:" + field.Name + "=\"" + field.Value + "\"";
  }
  return text;
}

std::string GPanoXmp(int width, int height, const PanoramaInfo& info)
{
  return XmpPacket(GPanoText(width, height, info));
}

std::string SphericalXmp(int width, int height, const PanoramaInfo& info)
{
  const bool beside = info.StereoMode == "left-right";
  std::string text = " xmlns:GSpherical=\"http://ns.google.com/videos/1.0/spherical/\""
                     "\n GSpherical:Spherical=\"true\"\n GSpherical:Stitched=\"true\""
                     "\n GSpherical:StitchingSoftware=\"VTKWideFoV\""
                     "\n GSpherical:ProjectionType=\"equirectangular\""
                     "\n GSpherical:StereoMode=\"" +
    info.StereoMode + "\"";
  for (const GPanoField& field :
    GPanoFields(beside ? width / 2 : width, beside ? height : height / 2, info))
  {
    // those that both name spaces have
    if (field.Name.rfind("Cropped", 0) == 0 || field.Name.rfind("FullPano", 0) == 0)
    {
      text += "\n GSpherical:" + field.Name + "=\"" + field.Value + "\"";
    }
  }
  return XmpPacket(text);
}

std::vector<unsigned char> PngXmpChunk(const std::string& xmp)
{
  // keyword, not compressed, no language, no translated keyword
  return MakeChunk("iTXt", std::string("XML:com.adobe.xmp") + std::string(5, '\0') + xmp);
}

void InsertInPng(std::vector<unsigned char>& png, const std::vector<unsigned char>& chunk)
{
  if (chunk.empty())
  {
    return;
  }
  if (png.size() < PngHeaderEnd || std::memcmp(png.data() + 12, "IHDR", 4) != 0)
  {
    Fail("the PNG encoder wrote no PNG; choose another format");
  }
  png.insert(png.begin() + PngHeaderEnd, chunk.begin(), chunk.end());
}
}
