// SPDX-License-Identifier: BSD-3-Clause
#include "Frame/ShaderClock.h"

#include "vtkShaderProgram.h"

namespace wfv
{
void ShaderClock::Begin()
{
  this->Start = std::chrono::steady_clock::now();
  this->Begun.Modified();
  this->Runs = true;
}

void ShaderClock::End(vtkShaderProgram* program)
{
  if (!this->Runs)
  {
    return;
  }
  this->Runs = false;
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - this->Start;
  this->Seconds += time.count();
  // one of the cache is older
  this->Programs += program->GetMTime() > this->Begun.GetMTime();
}
}
