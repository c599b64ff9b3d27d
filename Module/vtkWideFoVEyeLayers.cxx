// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWideFoVEyeLayers.h"

#include "vtkWideFoVDriver.h"
#include "vtkWideFoVGl.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkWeakPointer.h"

#include <algorithm>

namespace
{
constexpr int Eyes = 2;

// How pixels are kept; copies of depth, and of several samples a pixel, ask for the same in both.
struct Format
{
  GLenum Color = 0; // 0: of a kind that is not known
  GLenum Depth = 0;
  GLint Samples = 0;
  int Size[2] = { 0, 0 };

  bool IsKnown() const { return this->Color != 0 && this->Depth != 0; }
  bool operator==(const Format& o) const
  {
    return this->Color == o.Color && this->Depth == o.Depth && this->Samples == o.Samples &&
      this->Size[0] == o.Size[0] && this->Size[1] == o.Size[1];
  }
};

GLint Ask(GLenum attachment, GLenum what)
{
  GLint value = 0;
  glGetFramebufferAttachmentParameteriv(GL_DRAW_FRAMEBUFFER, attachment, what, &value);
  return value;
}

bool Has(GLenum attachment)
{
  return Ask(attachment, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE) != GL_NONE;
}

// Of the attachment that is drawn to.
GLenum ColorFormat()
{
  if (!Has(GL_COLOR_ATTACHMENT0))
  {
    return 0;
  }
  const GLint bits = Ask(GL_COLOR_ATTACHMENT0, GL_FRAMEBUFFER_ATTACHMENT_RED_SIZE);
  const GLint alpha = Ask(GL_COLOR_ATTACHMENT0, GL_FRAMEBUFFER_ATTACHMENT_ALPHA_SIZE);
  const GLint kind = Ask(GL_COLOR_ATTACHMENT0, GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE);
  const GLint encoding = Ask(GL_COLOR_ATTACHMENT0, GL_FRAMEBUFFER_ATTACHMENT_COLOR_ENCODING);
  if (alpha != bits || encoding != GL_LINEAR)
  {
    return 0;
  }
  if (kind == GL_UNSIGNED_NORMALIZED)
  {
    return bits == 8 ? GL_RGBA8 : bits == 16 ? GL_RGBA16 : 0;
  }
  return kind != GL_FLOAT ? 0 : bits == 16 ? GL_RGBA16F : bits == 32 ? GL_RGBA32F : 0;
}

GLenum DepthFormat()
{
  if (!Has(GL_DEPTH_ATTACHMENT))
  {
    return 0;
  }
  const GLint bits = Ask(GL_DEPTH_ATTACHMENT, GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE);
  const bool stencil = Has(GL_STENCIL_ATTACHMENT);
  if (Ask(GL_DEPTH_ATTACHMENT, GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE) == GL_FLOAT)
  {
    return stencil ? GL_DEPTH32F_STENCIL8 : GL_DEPTH_COMPONENT32F;
  }
  if (stencil)
  {
    return bits == 24 ? GL_DEPTH24_STENCIL8 : 0;
  }
  return bits == 16 ? GL_DEPTH_COMPONENT16
    : bits == 24    ? GL_DEPTH_COMPONENT24
    : bits == 32    ? GL_DEPTH_COMPONENT32
                    : 0;
}

// Of the framebuffer that is bound to be drawn to; the window's own, and one with several colours,
// are not known.
Format FormatOfTarget(const int size[2])
{
  Format format;
  GLint bound = 0;
  GLint buffers[2] = { GL_NONE, GL_NONE };
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
  glGetIntegerv(GL_DRAW_BUFFER0, &buffers[0]);
  glGetIntegerv(GL_DRAW_BUFFER1, &buffers[1]);
  if (bound != 0 && buffers[0] == GL_COLOR_ATTACHMENT0 && buffers[1] == GL_NONE)
  {
    format.Color = ColorFormat();
    format.Depth = DepthFormat();
    glGetIntegerv(GL_SAMPLES, &format.Samples);
  }
  std::copy_n(size, 2, format.Size);
  return format;
}

void AllocateTexture(GLuint texture, GLenum kind, const Format& f)
{
  const bool several = f.Samples > 0;
  const GLenum target = several ? GL_TEXTURE_2D_MULTISAMPLE_ARRAY : GL_TEXTURE_2D_ARRAY;
  glBindTexture(target, texture);
  if (several)
  {
    glTexImage3DMultisample(target, f.Samples, kind, f.Size[0], f.Size[1], Eyes, GL_TRUE);
  }
  else
  {
    const bool both = kind == GL_DEPTH24_STENCIL8 || kind == GL_DEPTH32F_STENCIL8;
    const GLenum values = kind == f.Color ? GL_RGBA : both ? GL_DEPTH_STENCIL : GL_DEPTH_COMPONENT;
    const GLenum type = kind == GL_DEPTH24_STENCIL8 ? GL_UNSIGNED_INT_24_8
      : both                                        ? GL_FLOAT_32_UNSIGNED_INT_24_8_REV
                                                    : GL_FLOAT;
    glTexImage3D(
      target, 0, static_cast<GLint>(kind), f.Size[0], f.Size[1], Eyes, 0, values, type, nullptr);
    glTexParameteri(target, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(target, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  }
  glBindTexture(target, 0);
}
}

namespace wfv
{
struct EyeLayers::Internals
{
  vtkWeakPointer<vtkOpenGLRenderWindow> Window; // whose they are
  Format Made;
  bool Complete = false;
  GLuint Color = 0;
  GLuint Depth = 0;
  GLuint Both = 0;              // framebuffer of all layers
  GLuint Each[Eyes] = { 0, 0 }; // and of one
  GLuint Target = 0;

  bool MakeFramebuffer(GLuint framebuffer, int layer) const;
  void Free(); // its window is current
  void Make(vtkOpenGLRenderWindow* window, const Format& format);
  void Copy(GLuint from, GLuint to, const int part[4]) const;
};

// layer: -1 for all.
bool EyeLayers::Internals::MakeFramebuffer(GLuint framebuffer, int layer) const
{
  const bool stencil =
    this->Made.Depth == GL_DEPTH24_STENCIL8 || this->Made.Depth == GL_DEPTH32F_STENCIL8;
  const GLenum depth = stencil ? GL_DEPTH_STENCIL_ATTACHMENT : GL_DEPTH_ATTACHMENT;
  this->Window->GetState()->vtkglBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  for (const GLenum place : { GLenum(GL_COLOR_ATTACHMENT0), depth })
  {
    const GLuint texture = place == depth ? this->Depth : this->Color;
    if (layer < 0)
    {
      glFramebufferTexture(GL_FRAMEBUFFER, place, texture, 0);
    }
    else
    {
      glFramebufferTextureLayer(GL_FRAMEBUFFER, place, texture, 0, layer);
    }
  }
  return glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

void EyeLayers::Internals::Make(vtkOpenGLRenderWindow* window, const Format& format)
{
  this->Window = window;
  this->Made = format;
  this->Complete = false;
  if (!format.IsKnown() || !HasExtension("GL_ARB_gpu_shader5") ||
    !HasExtension("GL_ARB_shader_viewport_layer_array"))
  {
    return;
  }
  GLuint textures[2];
  GLuint framebuffers[Eyes + 1];
  glGenTextures(2, textures);
  glGenFramebuffers(Eyes + 1, framebuffers);
  this->Color = textures[0];
  this->Depth = textures[1];
  this->Both = framebuffers[Eyes];
  std::copy_n(framebuffers, Eyes, this->Each);
  AllocateTexture(this->Color, format.Color, format);
  AllocateTexture(this->Depth, format.Depth, format);
  vtkOpenGLState* const state = window->GetState();
  state->PushFramebufferBindings();
  this->Complete = this->MakeFramebuffer(this->Both, -1);
  for (int i = 0; i < Eyes; i++)
  {
    this->Complete = this->MakeFramebuffer(this->Each[i], i) && this->Complete;
  }
  state->PopFramebufferBindings();
}

void EyeLayers::Internals::Free()
{
  if (this->Both != 0)
  {
    const GLuint textures[] = { this->Color, this->Depth };
    const GLuint framebuffers[] = { this->Both, this->Each[0], this->Each[1] };
    glDeleteTextures(2, textures);
    glDeleteFramebuffers(Eyes + 1, framebuffers);
  }
}

// Colour and depth. The framebuffers stay bound.
void EyeLayers::Internals::Copy(GLuint from, GLuint to, const int part[4]) const
{
  vtkOpenGLState* const state = this->Window->GetState();
  state->vtkglBindFramebuffer(GL_READ_FRAMEBUFFER, from);
  state->vtkglBindFramebuffer(GL_DRAW_FRAMEBUFFER, to);
  GLint buffer = GL_COLOR_ATTACHMENT0;
  glGetIntegerv(GL_READ_BUFFER, &buffer);
  glReadBuffer(GL_COLOR_ATTACHMENT0);
  const int right = part[0] + part[2];
  const int top = part[1] + part[3];
  glBlitFramebuffer(part[0], part[1], right, top, part[0], part[1], right, top,
    GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT, GL_NEAREST);
  glReadBuffer(static_cast<GLenum>(buffer));
}

EyeLayers::EyeLayers()
  : Internal(new Internals)
{
}

EyeLayers::~EyeLayers()
{
  this->ReleaseGraphicsResources(this->Internal->Window);
}

bool EyeLayers::Prepare(vtkOpenGLRenderWindow* window, const int size[2])
{
  Internals& in = *this->Internal;
  const Format wanted = FormatOfTarget(size);
  if (in.Window != window || !(in.Made == wanted))
  {
    this->ReleaseGraphicsResources(in.Window);
    in.Make(window, wanted);
  }
  return in.Complete;
}

bool EyeLayers::Fit(vtkOpenGLRenderWindow* window, const int size[2]) const
{
  const Internals& in = *this->Internal;
  return in.Complete && in.Window == window && in.Made == FormatOfTarget(size);
}

void EyeLayers::Begin(const int part[4])
{
  Internals& in = *this->Internal;
  GLint target = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &target);
  in.Target = static_cast<GLuint>(target);
  vtkOpenGLState* const state = in.Window->GetState();
  state->PushFramebufferBindings();
  for (const GLuint layer : in.Each)
  {
    in.Copy(in.Target, layer, part);
  }
  state->vtkglBindFramebuffer(GL_DRAW_FRAMEBUFFER, in.Both);
}

void EyeLayers::End()
{
  this->Internal->Window->GetState()->PopFramebufferBindings();
}

void EyeLayers::Show(int layer, const int part[4])
{
  Internals& in = *this->Internal;
  GLint target = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &target);
  vtkOpenGLState* const state = in.Window->GetState();
  state->PushFramebufferBindings();
  in.Copy(in.Each[layer], static_cast<GLuint>(target), part);
  state->PopFramebufferBindings();
}

void EyeLayers::ReleaseGraphicsResources(vtkWindow* window)
{
  Internals& in = *this->Internal;
  // those of a window that is gone are gone with it
  if (window && window == in.Window)
  {
    in.Window->PushContext();
    in.Free();
    in.Window->PopContext();
  }
  in.Color = in.Depth = in.Both = in.Each[0] = in.Each[1] = 0;
  in.Window = nullptr;
  in.Complete = false;
  in.Made = Format();
}
}
