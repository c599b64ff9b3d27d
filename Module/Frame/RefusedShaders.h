// SPDX-License-Identifier: BSD-3-Clause
// Shaders that the driver does not take.
#ifndef WideFoVRefusedShaders_h
#define WideFoVRefusedShaders_h

#include "Frame/ShaderMemory.h"

#include "vtkAbstractMapper.h"
#include "vtkObject.h"
#include "vtkOpenGLRenderPass.h"
#include "vtkProp.h"
#include "vtkRenderWindow.h"

namespace wfv
{
// A shader of OpenGL; 0, and the driver's log, where it does not compile. type: GL_VERTEX_SHADER...
unsigned int CompileShader(unsigned int type, const std::string& source, std::string& log);

// Whether others have their say about the shaders of a prop when this one of its passes has had
// its own: passes behind it, or replacements of the user's.
bool IsEditedFurther(vtkOpenGLRenderPass* pass, vtkProp* prop);

// Whether the driver refuses what becomes of these texts, which the pass has just made for the
// mapper. VTK's mappers do not expect that: up to 9.2 they ask the program that they did not get,
// and later ones draw with that of the prop before. The program is taken from VTK's cache, where
// the mapper then finds it: it is not made twice. Why is said by an error of `object`.
bool IsRefused(vtkObject* object, vtkRenderWindow* window, vtkOpenGLRenderPass* pass,
  vtkAbstractMapper* mapper, vtkProp* prop, const ShaderMemory::Texts& texts);

// An error of `object`, once in this process for what the driver's log begins with, whatever its
// numbers of lines are: a scene has dozens of programs that fail alike. what: "fragment shader of
// ...".
void ReportRefused(
  vtkObject* object, const std::string& what, const std::string& log, const char* instead);
}

#endif
