// SPDX-License-Identifier: BSD-3-Clause
#include "PanoramaXmp.h"

#include <cmath>
#include <sstream>

namespace wfvxmp
{
std::vector<Field> PanoramaFields(const Panorama& p)
{
  const long fullWidth = std::lround(p.Width * 360 / p.HorizontalFov);
  const long fullHeight = std::lround(p.Height * 180 / p.VerticalFov);
  const auto text = [](long value) { return std::to_string(value); };
  std::ostringstream pitch;
  pitch << p.Pitch;
  return { { "ProjectionType", "equirectangular" }, { "UsePanoramaViewer", "True" },
    { "CroppedAreaImageWidthPixels", text(p.Width) },
    { "CroppedAreaImageHeightPixels", text(p.Height) }, { "FullPanoWidthPixels", text(fullWidth) },
    { "FullPanoHeightPixels", text(fullHeight) },
    { "CroppedAreaLeftPixels", text((fullWidth - p.Width) / 2) },
    { "CroppedAreaTopPixels", text((fullHeight - p.Height) / 2) }, { "PoseHeadingDegrees", "0" },
    { "PosePitchDegrees", pitch.str() }, { "PoseRollDegrees", "0" } };
}

std::string PanoramaText(const Panorama& panorama)
{
  std::string text = " xmlns:GPano=\"http://ns.google.com/photos/1.0/panorama/\"";
  for (const Field& field : PanoramaFields(panorama))
  {
    text += "\n GPano:" + field.Name + "=\"" + field.Value + "\"";
  }
  return text;
}

std::string XmpPacket(const std::string& description)
{
  return "<?xpacket begin=\"\xEF\xBB\xBF\" id=\"W5M0MpCehiHzreSzNTczkc9d\"?>\n"
         "<x:xmpmeta xmlns:x=\"adobe:ns:meta/\">\n"
         "<rdf:RDF xmlns:rdf=\"http://www.w3.org/1999/02/22-rdf-syntax-ns#\">\n"
         "<rdf:Description rdf:about=\"\"\n" +
    description + "/>\n</rdf:RDF>\n</x:xmpmeta>\n<?xpacket end=\"w\"?>";
}

std::string PanoramaXmp(const Panorama& panorama)
{
  return XmpPacket(PanoramaText(panorama));
}
}
