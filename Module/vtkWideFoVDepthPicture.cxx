// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWideFoVDepthPicture.h"

#include "vtkWideFoVGl.h"

namespace
{
// Pixels of a picture that is not read: more than a screen has.
constexpr std::size_t MostPixels = 1 << 25;
}

namespace wfv
{
bool DepthPicture::Read(const int part[4])
{
  this->Depths.clear();
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
  this->Width = static_cast<std::size_t>(part[2]);
  this->Depths.resize(pixels);
  glReadPixels(
    part[0], part[1], part[2], part[3], GL_DEPTH_COMPONENT, GL_FLOAT, this->Depths.data());
  glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(read));
  return true;
}
}
