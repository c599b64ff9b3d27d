// SPDX-License-Identifier: BSD-3-Clause
// How many shader programs had to be made, and how long that took.
#ifndef WideFoVShaderClock_h
#define WideFoVShaderClock_h

#include "vtkWideFoVAbi.h"

#include "vtkTimeStamp.h"

#include <chrono>

VTK_ABI_NAMESPACE_BEGIN
class vtkShaderProgram;
VTK_ABI_NAMESPACE_END

namespace wfv
{
// A mapper asks its stage to add to the text of its shaders, has VTK's cache make a program of it,
// or find the one that it made before, and then asks the stage for uniforms: what lies between the
// first and the last is the text, and the compiler where the program is new. Drivers may compile
// once more when the program is first drawn with; that is in the time of the frame alone.
class ShaderClock
{
public:
  // Text is asked for.
  void Begin();

  // Uniforms are asked for.
  void End(vtkShaderProgram* program);

  // So far: programs that were not there before; seconds for text and programs.
  int GetNumberOfPrograms() const { return this->Programs; }
  double GetSeconds() const { return this->Seconds; }

private:
  std::chrono::steady_clock::time_point Start;
  vtkTimeStamp Begun;
  bool Runs = false;
  int Programs = 0;
  double Seconds = 0;
};
}

#endif
