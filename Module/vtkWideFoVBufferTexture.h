// SPDX-License-Identifier: BSD-3-Clause
// Numbers that a shader reads by their place (usamplerBuffer, samplerBuffer).
#ifndef vtkWideFoVBufferTexture_h
#define vtkWideFoVBufferTexture_h

#include "vtkWideFoVGl.h"

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
    this->LoadSingles(window, numbers, GL_R32UI, VTK_UNSIGNED_INT);
  }
  void Load(vtkOpenGLRenderWindow* window, const std::vector<unsigned char>& numbers)
  {
    this->LoadSingles(window, numbers, GL_R8UI, VTK_UNSIGNED_CHAR);
  }

  // Four a place, at least one.
  void LoadFours(vtkOpenGLRenderWindow* window, const std::vector<float>& numbers)
  {
    this->Texture->SetContext(window);
    this->Texture->SetInternalFormat(GL_RGBA32F);
    this->Texture->SetFormat(GL_RGBA);
    this->Buffer->Upload(numbers, vtkOpenGLBufferObject::TextureBuffer);
    this->Texture->CreateTextureBuffer(
      static_cast<unsigned int>(numbers.size() / 4), 4, VTK_FLOAT, this->Buffer);
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
  template <typename Number>
  void LoadSingles(vtkOpenGLRenderWindow* window, const std::vector<Number>& numbers,
    unsigned int format, int type)
  {
    this->Texture->SetContext(window);
    this->Texture->SetInternalFormat(format);
    this->Texture->SetFormat(GL_RED_INTEGER);
    this->Buffer->Upload(numbers, vtkOpenGLBufferObject::TextureBuffer);
    this->Texture->CreateTextureBuffer(
      static_cast<unsigned int>(numbers.size()), 1, type, this->Buffer);
  }

  vtkNew<vtkOpenGLBufferObject> Buffer;
  vtkNew<vtkTextureObject> Texture;
};
}

#endif
