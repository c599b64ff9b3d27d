// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMWideFoVPictureExtractWriterProxy.h"

#include "WidePicture.h"

#include "vtkObjectFactory.h"
#include "vtkPVSession.h"
#include "vtkSMExtractsController.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMViewProxy.h"

vtkStandardNewMacro(vtkSMWideFoVPictureExtractWriterProxy);

void vtkSMWideFoVPictureExtractWriterProxy::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

bool vtkSMWideFoVPictureExtractWriterProxy::CanExtract(vtkSMProxy* proxy)
{
  return wfvplugin::IsWideView(proxy);
}

bool vtkSMWideFoVPictureExtractWriterProxy::IsExtracting(vtkSMProxy* proxy)
{
  return this->GetInput() == proxy;
}

void vtkSMWideFoVPictureExtractWriterProxy::SetInput(vtkSMProxy* proxy)
{
  vtkSMPropertyHelper(this, "View").Set(proxy);
}

vtkSMProxy* vtkSMWideFoVPictureExtractWriterProxy::GetInput()
{
  return vtkSMPropertyHelper(this, "View").GetAsProxy();
}

bool vtkSMWideFoVPictureExtractWriterProxy::Write(vtkSMExtractsController* extractor)
{
  auto* const view = vtkSMViewProxy::SafeDownCast(this->GetInput());
  if (!view)
  {
    vtkErrorMacro("The extractor has no view");
    return false;
  }
  vtkSMPropertyHelper time(view, "ViewTime");
  const double before = time.GetAsDouble();
  time.Set(extractor->GetTime());
  view->UpdateVTKObjects();
  const std::string path = vtkSMExtractWriterProxy::GenerateExtractsFileName(
    vtkSMPropertyHelper(this, "FileName").GetAsString(),
    extractor->GetRealExtractsOutputDirectory());
  const auto files = wfvplugin::WriteWidePictures(view, this, path, vtkPVSession::DATA_SERVER_ROOT);
  time.Set(before);
  view->UpdateVTKObjects();
  for (const std::string& file : files)
  {
    extractor->AddSummaryEntry(this, file);
  }
  return !files.empty();
}
