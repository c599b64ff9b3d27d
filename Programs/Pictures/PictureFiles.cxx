// SPDX-License-Identifier: BSD-3-Clause
#include "PictureFiles.h"

#include "EyePictures.h"
#include "ImageOutput.h"
#include "Options/FilmOptions.h"
#include "Options/OutputNames.h"
#include "Options/StereoChoice.h"
#include "Options/StereoLayout.h"
#include "Warp.h"

#include <algorithm>
#include <cmath>

namespace widefov
{
PanoramaInfo DescribePanorama(const Options& o)
{
  const StereoLayout& layout = FindStereoLayout(o.Layout);
  const bool mono = !HasTwoEyes(o);
  PanoramaInfo info;
  info.StereoMode = mono ? "" : layout.SphericalMode();
  // of colours for glasses, of squeezed pictures, or of the cube of a map that is looked at again,
  // viewers know nothing
  const bool plain = mono || (!ShowsCube(o) && (layout.IsOneEye() || !info.StereoMode.empty()));
  // nor of what stands on its head, nor of two eyes that look up
  const double steepest = info.StereoMode.empty() ? 90 : 0; // degrees
  info.Pitch = o.View.Tilt;
  info.Equirectangular =
    plain && o.Projection == "equirectangular" && std::abs(info.Pitch) <= steepest;
  info.Description = HasFilm(o) ? o.Film.Command : "";
  info.HorizontalFov = o.View.HorizontalFov;
  info.VerticalFov = o.View.VerticalFov;
  if (o.Part)
  {
    info.Whole = o.Part->Whole;
    info.Before = { { o.Part->Start[0], o.Part->Whole[1] - o.Part->Start[1] - o.Size[1] } };
  }
  return info;
}

std::vector<std::pair<std::string, std::vector<unsigned char>>> EncodeFiles(
  const Options& o, const std::string& output, const std::vector<Picture>& unlit)
{
  std::vector<Picture> drawn = unlit;
  for (Picture& picture : drawn)
  {
    ApplyLight(o, picture);
  }
  const StereoLayout& layout = FindStereoLayout(o.Layout);
  const PanoramaInfo info = DescribePanorama(o);
  const std::vector<std::string> names = FilesOf(o, output);
  if (drawn.size() == 2 && layout.MultiView)
  {
    return { { names[0], EncodeMultiView(drawn, info) } };
  }
  if (drawn.size() == 2 && layout.Vr180 && IsVr180Photo(output))
  {
    return { { names[0], EncodeVr180Photo(drawn, info) } };
  }
  const std::vector<Picture> pictures = drawn.size() == 2 ? Arrange(layout, drawn) : drawn;
  std::vector<std::pair<std::string, std::vector<unsigned char>>> files;
  for (std::size_t i = 0; i < std::min(names.size(), pictures.size()); i++)
  {
    files.emplace_back(names[i], EncodePicture(pictures[i], names[i], info));
  }
  return files;
}
}
