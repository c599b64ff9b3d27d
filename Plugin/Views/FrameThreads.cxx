// SPDX-License-Identifier: BSD-3-Clause
#include "FrameThreads.h"

#include "vtkMultiProcessController.h"
#include "vtkSMP.h"
#include "vtkSMPTools.h"

#include <cstdlib>

namespace wfvplugin
{
bool HasOneRank()
{
  vtkMultiProcessController* const ranks = vtkMultiProcessController::GetGlobalController();
  return !ranks || ranks->GetNumberOfProcesses() == 1;
}

void FrameThreads::Begin()
{
#if VTK_SMP_ENABLE_STDTHREAD
  const std::string now = vtkSMPTools::GetBackend();
  if (this->Before.empty() && now == "Sequential" && !std::getenv("VTK_SMP_BACKEND_IN_USE") &&
    HasOneRank())
  {
    this->Before = now;
    vtkSMPTools::SetBackend("STDThread");
  }
#endif
}

void FrameThreads::End()
{
  if (!this->Before.empty())
  {
    vtkSMPTools::SetBackend(this->Before.c_str());
    this->Before.clear();
  }
}
}
