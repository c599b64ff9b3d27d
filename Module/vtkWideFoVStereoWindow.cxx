// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWideFoVStereoWindow.h"

#include "vtkWideFoVCamera.h"

#include "vtkCellArray.h"
#include "vtkCoordinate.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper2D.h"
#include "vtkProperty2D.h"
#include "vtkRenderer.h"

vtkStandardNewMacro(vtkWideFoVStereoWindow);

namespace
{
constexpr int Bars = 3; // one beside the picture, two of the letterbox
}

vtkWideFoVStereoWindow::vtkWideFoVStereoWindow()
{
  vtkNew<vtkCellArray> bars;
  this->Corners->SetNumberOfPoints(4 * static_cast<vtkIdType>(Bars));
  for (vtkIdType i = 0; i < Bars; i++)
  {
    const vtkIdType corners[4] = { 4 * i, 4 * i + 1, 4 * i + 2, 4 * i + 3 };
    bars->InsertNextCell(4, corners);
  }
  vtkNew<vtkPolyData> shapes;
  shapes->SetPoints(this->Corners);
  shapes->SetPolys(bars);
  vtkNew<vtkCoordinate> part;
  part->SetCoordinateSystemToNormalizedViewport();
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(shapes);
  mapper->SetTransformCoordinate(part);
  this->SetMapper(mapper);
  this->GetProperty()->SetColor(0, 0, 0);
  this->GetProperty()->SetDisplayLocationToForeground();
  this->PlaceBars(vtkWideFoVCamera::MIDDLE_EYE);
}

vtkWideFoVStereoWindow::~vtkWideFoVStereoWindow() = default;

void vtkWideFoVStereoWindow::PlaceBars(int eye)
{
  const double wide = eye == vtkWideFoVCamera::MIDDLE_EYE ? 0 : this->Floating;
  const bool left = eye == vtkWideFoVCamera::LEFT_EYE;
  const double high = this->Letterbox;
  // a hair beyond the borders: what ends on one may leave a row of pixels
  constexpr double Beyond = 0.01;
  const double low = -Beyond;
  const double end = 1 + Beyond;
  const double rectangles[Bars][4] = { { left ? low : 1 - wide, low, left ? wide : end, end },
    { low, low, end, high }, { low, 1 - high, end, end } };
  for (int i = 0; i < Bars; i++)
  {
    const bool none = i == 0 ? wide <= 0 : high <= 0;
    const double* const r = rectangles[i];
    for (int j = 0; j < 4; j++)
    {
      const double x = j == 1 || j == 2 ? r[2] : r[0];
      const double y = j > 1 ? r[3] : r[1];
      this->Corners->SetPoint(4 * i + j, none ? low : x, none ? low : y, 0);
    }
  }
  this->Corners->Modified();
}

int vtkWideFoVStereoWindow::RenderOverlay(vtkViewport* viewport)
{
  auto* const renderer = vtkRenderer::SafeDownCast(viewport);
  auto* const camera =
    renderer ? vtkWideFoVCamera::SafeDownCast(renderer->GetActiveCamera()) : nullptr;
  this->PlaceBars(camera ? camera->GetCurrentEye() : vtkWideFoVCamera::MIDDLE_EYE);
  return this->Superclass::RenderOverlay(viewport);
}

void vtkWideFoVStereoWindow::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Floating: " << this->Floating << "\n"
     << indent << "Letterbox: " << this->Letterbox << "\n";
}
