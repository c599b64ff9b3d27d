// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWideFoVDepthPicture.h"

#include "vtkWideFoVGl.h"

#include <algorithm>
#include <cmath>

namespace
{
// Pixels of a picture that is not read: more than a screen has.
constexpr std::size_t MostPixels = 1 << 25;

// Blocks along an axis that are looked at for a rectangle, beside the first one.
constexpr int MostBlocks = 3;
}

namespace wfv
{
bool DepthPicture::Read(const int part[4])
{
  this->Clear();
  GLint samples = 0;
  glGetIntegerv(GL_SAMPLES, &samples);
  const std::size_t pixels = static_cast<std::size_t>(part[2]) * static_cast<std::size_t>(part[3]);
  if (samples > 1 || part[2] < 1 || part[3] < 1 || pixels > MostPixels)
  {
    return false;
  }
  GLint drawn = 0;
  GLint read = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &drawn);
  glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &read);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(drawn));
  std::vector<float> depths(pixels);
  glReadPixels(part[0], part[1], part[2], part[3], GL_DEPTH_COMPONENT, GL_FLOAT, depths.data());
  glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(read));
  this->Take(part[2], part[3], std::move(depths));
  return true;
}

void DepthPicture::Take(int width, int height, std::vector<float> depths)
{
  this->Clear();
  this->Levels.push_back({ width, height, std::move(depths) });
  while (this->Levels.back().Width > 1 || this->Levels.back().Height > 1)
  {
    this->Levels.push_back(Halve(this->Levels.back()));
  }
}

DepthPicture::Level DepthPicture::Halve(const Level& level)
{
  Level half{ (level.Width + 1) / 2, (level.Height + 1) / 2, {} };
  half.Depths.resize(static_cast<std::size_t>(half.Width) * half.Height);
  for (int y = 0; y < level.Height; y++)
  {
    const float* const row = level.Depths.data() + static_cast<std::size_t>(y) * level.Width;
    float* const to = half.Depths.data() + static_cast<std::size_t>(y / 2) * half.Width;
    for (int x = 0; x < level.Width; x++)
    {
      to[x / 2] = std::max(to[x / 2], row[x]);
    }
  }
  return half;
}

double DepthPicture::GetFarthest(const vec2& low, const vec2& high) const
{
  if (this->Levels.empty() || !std::isfinite(low.x + low.y + high.x + high.y))
  {
    return 1;
  }
  const Level& all = this->Levels.front();
  if (high.x < 0 || high.y < 0 || low.x >= all.Width || low.y >= all.Height)
  {
    return 0;
  }
  int from[2] = { static_cast<int>(std::max(low.x, 0.0)), static_cast<int>(std::max(low.y, 0.0)) };
  int to[2] = { static_cast<int>(std::min(high.x, all.Width - 1.0)),
    static_cast<int>(std::min(high.y, all.Height - 1.0)) };
  std::size_t level = 0;
  for (; to[0] - from[0] > MostBlocks || to[1] - from[1] > MostBlocks; level++)
  {
    for (int i = 0; i < 2; i++)
    {
      from[i] /= 2;
      to[i] /= 2;
    }
  }
  const Level& blocks = this->Levels[level];
  float farthest = 0;
  for (int y = from[1]; y <= to[1]; y++)
  {
    const float* const row = blocks.Depths.data() + static_cast<std::size_t>(y) * blocks.Width;
    farthest = std::max(farthest, *std::max_element(row + from[0], row + to[0] + 1));
  }
  return farthest;
}
}
