// SPDX-License-Identifier: BSD-3-Clause
#include "EyePictures.h"

#include <algorithm>

namespace widefov
{
Picture Join(const Picture& first, const Picture& second, bool below)
{
  Picture joined;
  joined.Width = below ? first.Width : first.Width + second.Width;
  joined.Height = below ? first.Height + second.Height : first.Height;
  const auto row = [](const Picture& p, int j) {
    const std::size_t bytes = 3 * static_cast<std::size_t>(p.Width);
    return p.Rgb.begin() + static_cast<std::ptrdiff_t>(bytes * j);
  };
  for (int j = 0; j < first.Height; j++)
  {
    joined.Rgb.insert(joined.Rgb.end(), row(first, j), row(first, j + 1));
    if (!below)
    {
      joined.Rgb.insert(joined.Rgb.end(), row(second, j), row(second, j + 1));
    }
  }
  if (below)
  {
    joined.Rgb.insert(joined.Rgb.end(), second.Rgb.begin(), second.Rgb.end());
  }
  return joined;
}

Picture Halve(const Picture& picture, bool height)
{
  Picture half;
  half.Width = height ? picture.Width : (picture.Width + 1) / 2;
  half.Height = height ? (picture.Height + 1) / 2 : picture.Height;
  half.Rgb.reserve(3 * static_cast<std::size_t>(half.Width) * half.Height);
  const auto at = [&](int i, int j, int c) {
    const std::size_t pixel = static_cast<std::size_t>(j) * picture.Width + i;
    return static_cast<int>(picture.Rgb[3 * pixel + c]);
  };
  for (int j = 0; j < half.Height; j++)
  {
    for (int i = 0; i < half.Width; i++)
    {
      const int i0 = height ? i : 2 * i;
      const int j0 = height ? 2 * j : j;
      const int i1 = std::min(height ? i0 : i0 + 1, picture.Width - 1);
      const int j1 = std::min(height ? j0 + 1 : j0, picture.Height - 1);
      for (int c = 0; c < 3; c++)
      {
        half.Rgb.push_back(static_cast<unsigned char>((at(i0, j0, c) + at(i1, j1, c) + 1) / 2));
      }
    }
  }
  return half;
}

std::vector<Picture> Arrange(const StereoLayout& layout, const std::vector<Picture>& eyes)
{
  if (layout.Columns * layout.Rows == 1)
  {
    return eyes;
  }
  const bool below = layout.Rows == 2;
  return layout.Half
    ? std::vector<Picture>{ Join(Halve(eyes[0], below), Halve(eyes[1], below), below) }
    : std::vector<Picture>{ Join(eyes[0], eyes[1], below) };
}
}
