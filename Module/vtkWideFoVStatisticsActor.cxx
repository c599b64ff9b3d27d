// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWideFoVStatisticsActor.h"

#include "vtkWideFoVPass.h"

#include "vtkCoordinate.h"
#include "vtkObjectFactory.h"
#include "vtkRenderer.h"
#include "vtkTextProperty.h"

#include <cstdio>
#include <string>

vtkStandardNewMacro(vtkWideFoVStatisticsActor);

vtkWideFoVStatisticsActor::vtkWideFoVStatisticsActor()
{
  vtkTextProperty* const look = this->GetTextProperty();
  look->SetFontFamilyToCourier();
  look->SetFontSize(14);
  look->BoldOn();
  look->SetColor(1, 1, 1);
  look->SetBackgroundColor(0, 0, 0);
  look->SetBackgroundOpacity(0.5);
  look->SetVerticalJustificationToTop();
  this->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  this->SetPosition(0.01, 0.99);
}

vtkWideFoVStatisticsActor::~vtkWideFoVStatisticsActor() = default;

void vtkWideFoVStatisticsActor::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Pass: " << this->Pass.Get() << "\n";
}

void vtkWideFoVStatisticsActor::SetPass(vtkWideFoVPass* pass)
{
  if (this->Pass != pass)
  {
    this->Pass = pass;
    this->Modified();
  }
}

vtkWideFoVPass* vtkWideFoVStatisticsActor::GetPass()
{
  return this->Pass;
}

// The frame has yet to be drawn.
int vtkWideFoVStatisticsActor::RenderOpaqueGeometry(vtkViewport*)
{
  return 0;
}

int vtkWideFoVStatisticsActor::RenderOverlay(vtkViewport* viewport)
{
  std::string text = this->Pass ? this->Pass->GetStatistics() : "";
  auto* const renderer = vtkRenderer::SafeDownCast(viewport);
  const double took = renderer ? renderer->GetLastRenderTimeInSeconds() : -1; // none was before
  if (!text.empty() && took >= 0)
  {
    char line[64];
    std::snprintf(line, sizeof(line), "\nthe frame before: %.1f ms", 1000 * took);
    text += line;
  }
  this->SetInput(text.c_str());
  this->Superclass::RenderOpaqueGeometry(viewport); // makes the letters
  return this->Superclass::RenderOverlay(viewport);
}
