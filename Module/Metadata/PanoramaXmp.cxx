// SPDX-License-Identifier: BSD-3-Clause
#include "PanoramaXmp.h"

#include <cmath>
#include <sstream>

namespace wfvxmp
{
std::vector<Field> PanoramaFields(const Panorama& p)
{
  const int width = p.Whole[0] > 0 ? p.Whole[0] : p.Width;
  const int height = p.Whole[1] > 0 ? p.Whole[1] : p.Height;
  const long fullWidth = std::lround(width * 360 / p.HorizontalFov);
  const long fullHeight = std::lround(height * 180 / p.VerticalFov);
  const auto text = [](long value) { return std::to_string(value); };
  std::ostringstream pitch;
  pitch << p.Pitch;
  return { { "ProjectionType", "equirectangular" }, { "UsePanoramaViewer", "True" },
    { "CroppedAreaImageWidthPixels", text(p.Width) },
    { "CroppedAreaImageHeightPixels", text(p.Height) }, { "FullPanoWidthPixels", text(fullWidth) },
    { "FullPanoHeightPixels", text(fullHeight) },
    { "CroppedAreaLeftPixels", text((fullWidth - width) / 2 + p.Before[0]) },
    { "CroppedAreaTopPixels", text((fullHeight - height) / 2 + p.Before[1]) },
    { "PoseHeadingDegrees", "0" }, { "PosePitchDegrees", pitch.str() },
    { "PoseRollDegrees", "0" } };
}

std::vector<Field> CroppedFields(const Panorama& panorama)
{
  std::vector<Field> cropped;
  for (const Field& field : PanoramaFields(panorama))
  {
    if (field.Name.rfind("Cropped", 0) == 0 || field.Name.rfind("FullPano", 0) == 0)
    {
      cropped.push_back(field);
    }
  }
  return cropped;
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

std::string SphericalXmp(const Panorama& eye, const std::string& stereoMode)
{
  std::vector<Field> fields{ { "Spherical", "true" }, { "Stitched", "true" },
    { "StitchingSoftware", "VTKWideFoV" }, { "ProjectionType", "equirectangular" },
    { "StereoMode", stereoMode } };
  const std::vector<Field> cropped = CroppedFields(eye);
  fields.insert(fields.end(), cropped.begin(), cropped.end());
  std::string text = " xmlns:GSpherical=\"http://ns.google.com/videos/1.0/spherical/\"";
  for (const Field& field : fields)
  {
    text += "\n GSpherical:" + field.Name + "=\"" + field.Value + "\"";
  }
  return XmpPacket(text);
}
}
