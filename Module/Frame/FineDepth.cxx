// SPDX-License-Identifier: BSD-3-Clause
#include "Frame/FineDepth.h"

#include "Compat/Gl.h"

#include "vtkActor.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"

#include <algorithm>

namespace
{
// Image units are apart from texture units, and VTK uses none.
constexpr int ImageUnit = 0;

int BoundFramebuffer()
{
  int bound = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
  return bound;
}

// The depth buffer lets the nearest through, and nothing else decides.
bool NearestIsSeen()
{
  int order = 0;
  glGetIntegerv(GL_DEPTH_FUNC, &order);
  GLboolean kept = GL_FALSE;
  glGetBooleanv(GL_DEPTH_WRITEMASK, &kept);
  return glIsEnabled(GL_DEPTH_TEST) && kept && (order == GL_LESS || order == GL_LEQUAL) &&
    !glIsEnabled(GL_STENCIL_TEST);
}

// OpenGL 4.4 clears textures, 4.2 has images. Not asked by extensions: the loader of VTK 9.4 and
// later has the functions of the version alone.
bool HasImages()
{
  int version[2] = { 0, 0 };
  glGetIntegerv(GL_MAJOR_VERSION, &version[0]);
  glGetIntegerv(GL_MINOR_VERSION, &version[1]);
  return version[0] > 4 || (version[0] == 4 && version[1] >= 4);
}

bool IsOpaque(vtkProp* prop)
{
  auto* const actor = vtkActor::SafeDownCast(prop);
  return actor && !actor->IsRenderingTranslucentPolygonalGeometry();
}
}

namespace wfv
{
void FineDepth::Begin(vtkRenderer* renderer)
{
  this->Window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  this->Framebuffer = BoundFramebuffer();
  this->Cleared = false;
}

bool FineDepth::IsFor(const int viewport[4]) const
{
  return this->Window && BoundFramebuffer() == this->Framebuffer &&
    (!this->Cleared || std::equal(viewport, viewport + 4, this->Viewport));
}

bool FineDepth::Prepare(const int viewport[4])
{
  if (this->Cleared)
  {
    return true;
  }
  if (!HasImages() || viewport[2] <= 0 || viewport[3] <= 0)
  {
    return false;
  }
  const auto width = static_cast<unsigned int>(viewport[2]);
  const auto height = static_cast<unsigned int>(viewport[3]);
  if (this->Nearest->GetContext() != this->Window || this->Nearest->GetHandle() == 0 ||
    this->Nearest->GetWidth() != width || this->Nearest->GetHeight() != height)
  {
    this->Nearest->SetContext(this->Window);
    this->Nearest->SetInternalFormat(GL_R32UI);
    this->Nearest->SetFormat(GL_RED_INTEGER);
    this->Nearest->SetDataType(GL_UNSIGNED_INT);
    this->Nearest->SetMinificationFilter(vtkTextureObject::Nearest);
    this->Nearest->SetMagnificationFilter(vtkTextureObject::Nearest);
    if (!this->Nearest->Allocate2D(width, height, 1, VTK_UNSIGNED_INT))
    {
      return false;
    }
  }
  const GLuint farthest = ~0u;
  glClearTexImage(this->Nearest->GetHandle(), 0, GL_RED_INTEGER, GL_UNSIGNED_INT, &farthest);
  glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
  std::copy_n(viewport, 4, this->Viewport);
  this->Cleared = true;
  return true;
}

void FineDepth::SetParameters(vtkShaderProgram* program, vtkProp* prop, const int viewport[4])
{
  const bool known =
    IsOpaque(prop) && NearestIsSeen() && this->IsFor(viewport) && this->Prepare(viewport);
  program->SetUniformi("wfvNearestKnown", known);
  if (known)
  {
    glBindImageTexture(
      ImageUnit, this->Nearest->GetHandle(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_R32UI);
    program->SetUniformi("wfvNearest", ImageUnit);
    program->SetUniform2i("wfvNearestFrom", viewport);
  }
}

void FineDepth::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Nearest->ReleaseGraphicsResources(window);
  this->Cleared = false;
}
}
