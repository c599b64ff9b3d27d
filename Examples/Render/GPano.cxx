// SPDX-License-Identifier: BSD-3-Clause
#include "GPano.h"

#include "Messages.h"

namespace widefov
{
namespace
{
wfvxmp::Panorama PanoramaOf(int width, int height, const PanoramaInfo& info)
{
  wfvxmp::Panorama panorama;
  panorama.Width = width;
  panorama.Height = height;
  panorama.HorizontalFov = info.HorizontalFov;
  panorama.VerticalFov = info.VerticalFov;
  return panorama;
}
}

std::vector<wfvxmp::Field> GPanoFields(int width, int height, const PanoramaInfo& info)
{
  return wfvxmp::PanoramaFields(PanoramaOf(width, height, info));
}

std::string GPanoText(int width, int height, const PanoramaInfo& info)
{
  return wfvxmp::PanoramaText(PanoramaOf(width, height, info));
}

std::string GPanoXmp(int width, int height, const PanoramaInfo& info)
{
  return wfvxmp::PanoramaXmp(PanoramaOf(width, height, info));
}

std::string CroppedFields(int width, int height, const PanoramaInfo& info, const FieldText& write)
{
  std::string text;
  for (const wfvxmp::Field& field : GPanoFields(width, height, info))
  {
    if (field.Name.rfind("Cropped", 0) == 0 || field.Name.rfind("FullPano", 0) == 0)
    {
      text += write(field.Name, field.Value);
    }
  }
  return text;
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
  const auto attribute = [](const std::string& name, const std::string& value) {
    return "\n GSpherical:" + name + "=\"" + value + "\"";
  };
  text += CroppedFields(beside ? width / 2 : width, beside ? height : height / 2, info, attribute);
  return wfvxmp::XmpPacket(text);
}

void InsertInPng(std::vector<unsigned char>& png, const std::vector<unsigned char>& chunk)
{
  if (!chunk.empty() && !wfvxmp::InsertInPng(png, chunk))
  {
    Fail("the PNG encoder wrote no PNG; choose another format");
  }
}
}
