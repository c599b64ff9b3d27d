// SPDX-License-Identifier: BSD-3-Clause
#include "Aov.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>

#include <algorithm>
#include <utility>

namespace widefov
{
namespace
{
// Arrays of the data pass, and the channels of their components.
using ArrayList = std::vector<std::pair<const char*, std::vector<std::string>>>;

const ArrayList& Arrays()
{
  static const ArrayList arrays{ { "color", { "R", "G", "B", "A" } },
    { "distance", { "distance" } }, { "cell", { "cell" } }, { "prop", { "prop" } },
    { "normal", { "normal.X", "normal.Y", "normal.Z" } } };
  return arrays;
}

// The channel "prop" from 1 + number of the actor to 1 + index of the file.
void NumberByFile(FloatPicture& picture, const Scene& scene)
{
  const std::size_t stride = picture.Channels.size();
  const auto channel = static_cast<std::size_t>(
    std::find(picture.Channels.begin(), picture.Channels.end(), "prop") - picture.Channels.begin());
  for (std::size_t i = channel; i < picture.Values.size(); i += stride)
  {
    const auto actor = static_cast<std::size_t>(picture.Values[i]);
    if (actor > 0)
    {
      picture.Values[i] = static_cast<float>(1 + scene.Props[actor - 1].Index);
    }
  }
}
}

const std::vector<std::string>& AovChannels()
{
  static const std::vector<std::string> all = [] {
    std::vector<std::string> names;
    for (const auto& [name, channels] : Arrays())
    {
      names.insert(names.end(), channels.begin(), channels.end());
    }
    return names;
  }();
  return all;
}

FloatPicture FlattenAov(vtkImageData* image, const Scene& scene)
{
  const ArrayList& arrays = Arrays();
  FloatPicture picture;
  picture.Width = image->GetDimensions()[0];
  picture.Height = image->GetDimensions()[1];
  picture.Channels = AovChannels();
  const std::size_t stride = picture.Channels.size();
  picture.Values.resize(stride * picture.Width * picture.Height);
  const vtkIdType top = picture.Height - 1;
  std::size_t channel = 0;
  for (const auto& [name, channels] : arrays)
  {
    vtkDataArray* const array = image->GetPointData()->GetArray(name);
    for (int c = 0; c < static_cast<int>(channels.size()); c++, channel++)
    {
      for (int j = 0; j < picture.Height; j++)
      {
        const vtkIdType from = (top - j) * picture.Width;
        float* to = &picture.Values[stride * j * picture.Width + channel];
        for (int i = 0; i < picture.Width; i++, to += stride)
        {
          *to = static_cast<float>(array->GetComponent(from + i, c));
        }
      }
    }
  }
  NumberByFile(picture, scene);
  return picture;
}

void CopyBeside(const FloatPicture& tile, int at, FloatPicture& band)
{
  const std::size_t stride = band.Channels.size();
  for (int j = 0; j < tile.Height; j++)
  {
    const auto from = static_cast<std::ptrdiff_t>(stride * j * tile.Width);
    const auto row = static_cast<std::ptrdiff_t>(stride * tile.Width);
    std::copy(tile.Values.begin() + from, tile.Values.begin() + from + row,
      band.Values.begin() +
        static_cast<std::ptrdiff_t>(stride * (std::size_t(j) * band.Width + at)));
  }
}
}
