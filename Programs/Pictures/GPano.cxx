// SPDX-License-Identifier: BSD-3-Clause
#include "GPano.h"

#include "Text/Messages.h"

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
  panorama.Pitch = info.Pitch;
  panorama.Whole = info.Whole;
  panorama.Before = info.Before;
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

std::vector<wfvxmp::Field> CroppedFields(int width, int height, const PanoramaInfo& info)
{
  return wfvxmp::CroppedFields(PanoramaOf(width, height, info));
}

std::string SphericalXmp(int width, int height, const PanoramaInfo& info)
{
  const bool beside = info.StereoMode == "left-right";
  const int columns = beside ? width / 2 : width;
  const int rows = beside ? height : height / 2;
  return wfvxmp::SphericalXmp(PanoramaOf(columns, rows, info), info.StereoMode);
}

void InsertInPng(std::vector<unsigned char>& png, const std::vector<unsigned char>& chunk)
{
  if (!chunk.empty() && !wfvxmp::InsertInPng(png, chunk))
  {
    Fail("the PNG encoder wrote no PNG; choose another format");
  }
}
}
