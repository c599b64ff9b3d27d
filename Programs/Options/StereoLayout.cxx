// SPDX-License-Identifier: BSD-3-Clause
#include "StereoLayout.h"

#include <vtkRenderWindow.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>

namespace widefov
{
namespace
{
const std::vector<int> Both{ VTK_STEREO_LEFT, VTK_STEREO_RIGHT };

const std::vector<StereoLayout>& Layouts()
{
  static const std::vector<StereoLayout> all{ { "anaglyph", { VTK_STEREO_ANAGLYPH } },
    { "left", { VTK_STEREO_LEFT } }, { "right", { VTK_STEREO_RIGHT } },
    { "separate", Both, 1, 1, false, true }, { "multi-view", Both, 1, 1, false, false, true },
    { "vr180", Both, 2, 1, false, false, false, true }, { "side-by-side", Both, 2 },
    { "side-by-side-half", Both, 2, 1, true }, { "top-bottom", Both, 1, 2 },
    { "top-bottom-half", Both, 1, 2, true }, { "red-blue", { VTK_STEREO_RED_BLUE } },
    { "interlaced", { VTK_STEREO_INTERLACED } }, { "checkerboard", { VTK_STEREO_CHECKERBOARD } },
    { "split", { VTK_STEREO_SPLITVIEWPORT_HORIZONTAL } }, { "dresden", { VTK_STEREO_DRESDEN } },
    { "frame-sequential", Both, 1, 1, false, false, false, false, true } };
  return all;
}
}

std::vector<std::string> StereoLayoutNames()
{
  std::vector<std::string> names;
  for (const StereoLayout& layout : Layouts())
  {
    names.push_back(layout.Name);
  }
  return names;
}

const StereoLayout& FindStereoLayout(const std::string& name)
{
  for (const StereoLayout& layout : Layouts())
  {
    if (layout.Name == name)
    {
      return layout;
    }
  }
  throw std::logic_error("no stereo layout is named " + name);
}

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

std::string FileOfEye(const StereoLayout& layout, const std::string& path, std::size_t i)
{
  if (!layout.Separate)
  {
    return path;
  }
  std::filesystem::path file(path);
  const std::string name = file.stem().string() + (i == 0 ? "-left" : "-right");
  return file.replace_filename(name + file.extension().string()).string();
}
}
