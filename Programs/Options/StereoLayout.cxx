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
