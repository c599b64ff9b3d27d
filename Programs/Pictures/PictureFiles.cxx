// SPDX-License-Identifier: BSD-3-Clause
#include "PictureFiles.h"

#include "Options/StereoChoice.h"
#include "Options/StereoLayout.h"
#include "Options/StereoOptions.h"

#include <algorithm>

namespace widefov
{
std::vector<std::pair<std::string, std::vector<unsigned char>>> EncodeFiles(
  const Options& o, const std::string& output, const std::vector<Picture>& drawn)
{
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

std::array<int, 2> SizeOfFile(const Options& o)
{
  std::array<int, 2> size = o.Size;
  if (HasTwoEyes(o))
  {
    const StereoLayout& layout = FindStereoLayout(o.Layout);
    const auto times = [&layout](int pixels, int eyes) {
      return eyes * (layout.Half && eyes == 2 ? (pixels + 1) / 2 : pixels);
    };
    size = { { times(size[0], layout.Columns), times(size[1], layout.Rows) } };
  }
  return size;
}
}
