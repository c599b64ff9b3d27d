// SPDX-License-Identifier: BSD-3-Clause
// Numbers that a shader reads by their place (usamplerBuffer).
#ifndef WideFoVBufferTexture_h
#define WideFoVBufferTexture_h

#include "Compat/Gl.h"

#include "vtkNew.h"
#include "vtkOpenGLBufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <vector>

namespace wfv
{
class BufferTexture
{
public:
  BufferTexture() { this->Buffer->SetType(vtkOpenGLBufferObject::TextureBuffer); }

  bool IsLoadedFor(vtkOpenGLRenderWindow* window) const
  {
    return this->Texture->GetHandle() != 0 && this->Texture->GetContext() == window;
  }

  // At least one.
  void Load(vtkOpenGLRenderWindow* window, const std::vector<unsigned int>& numbers)
  {
    this->Texture->SetContext(window);
    this->Texture->SetInternalFormat(GL_R32UI);
    this->Texture->SetFormat(GL_RED_INTEGER);
    this->Buffer->Upload(numbers, vtkOpenGLBufferObject::TextureBuffer);
    this->Texture->CreateTextureBuffer(
      static_cast<unsigned int>(numbers.size()), 1, VTK_UNSIGNED_INT, this->Buffer);
  }

  void Activate(vtkShaderProgram* program, const char* name)
  {
    this->Texture->Activate();
    program->SetUniformi(name, this->Texture->GetTextureUnit());
  }

  void Deactivate()
  {
    if (this->Texture->GetHandle())
    {
      this->Texture->Deactivate();
    }
  }

  void ReleaseGraphicsResources(vtkWindow* window)
  {
    this->Texture->ReleaseGraphicsResources(window);
    this->Buffer->ReleaseGraphicsResources();
  }

private:
  vtkNew<vtkOpenGLBufferObject> Buffer;
  vtkNew<vtkTextureObject> Texture;
};
}

#endif
