// SPDX-License-Identifier: BSD-3-Clause
#include "CellPictures.h"

#include "BenchStage.h"
#include "Pictures/CameraSetup.h"
#include "System/Display.h"
#include "Pictures/Passes.h"

#include <vtkCellData.h>
#include <vtkPanoramicProjectionPass.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>

namespace wfv
{
namespace bench
{
namespace
{
// The same triangles, each in the colour that is its number from `first` on.
vtkSmartPointer<vtkPolyData> InNumbers(vtkPolyData* surface, vtkIdType first)
{
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(3);
  colors->SetNumberOfTuples(surface->GetNumberOfCells());
  for (vtkIdType i = 0; i < surface->GetNumberOfCells(); ++i)
  {
    const vtkIdType n = first + i + 1;
    const unsigned char rgb[3] = { static_cast<unsigned char>(n >> 16),
      static_cast<unsigned char>(n >> 8), static_cast<unsigned char>(n) };
    colors->SetTypedTuple(i, rgb);
  }
  auto numbered = vtkSmartPointer<vtkPolyData>::New();
  numbered->SetPoints(surface->GetPoints());
  numbered->SetPolys(surface->GetPolys());
  numbered->GetCellData()->SetScalars(colors);
  return numbered;
}

vtkSmartPointer<vtkActor> NumberActor(vtkPolyData* surface, vtkIdType first)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(InNumbers(surface, first));
  mapper->SetScalarModeToUseCellData();
  mapper->SetColorModeToDirectScalars();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  return actor;
}

reference::DrawnPicture ReadNumbers(vtkRenderWindow* window, int width, int height)
{
  vtkNew<vtkUnsignedCharArray> pixels;
  window->GetPixelData(0, 0, width - 1, height - 1, 0, pixels);
  reference::DrawnPicture picture;
  picture.Width = width;
  picture.Height = height;
  for (int j = height - 1; j >= 0; --j)
  {
    for (int i = 0; i < width; ++i)
    {
      const unsigned char* rgb = pixels->GetPointer(3 * (vtkIdType(j) * width + i));
      picture.Cell.push_back(float((rgb[0] << 16) + (rgb[1] << 8) + rgb[2]));
      picture.Distance.push_back(0);
    }
  }
  return picture;
}
}

DataPicture::DataPicture(BenchEntry& entry)
  : Entry(entry)
  , Before(entry.Renderer->GetPass())
{
  vtkSmartPointer<vtkWideFoVPass> delegate = entry.WidePass;
  if (!delegate)
  {
    delegate = vtkSmartPointer<vtkWideFoVPass>::New(); // draws a stock camera as stock VTK
  }
  for (std::size_t i = 0; i < entry.Actors.size(); ++i)
  {
    this->Data->SetPropIndex(entry.Actors[i], int(i));
  }
  this->Data->SetDelegatePass(delegate);
  entry.Renderer->SetPass(this->Data);
}

DataPicture::~DataPicture()
{
  this->Data->ReleaseGraphicsResources(this->Entry.Window);
  this->Entry.Renderer->SetPass(this->Before);
}

reference::DrawnPicture DataPicture::Draw(const std::vector<vtkIdType>& firstCells)
{
  this->Entry.Window->MakeCurrent();
  this->Entry.Window->Render();
  return reference::ToDrawnPicture(this->Data->GetOutput(), firstCells);
}

long CountCovered(const reference::DrawnPicture& picture)
{
  return std::count_if(
    picture.Cell.begin(), picture.Cell.end(), [](float cell) { return cell > 0; });
}

reference::DrawnPicture DrawCubeMapCells(const BenchEntry& entry, const BenchScene& scene)
{
  const widefov::Options& o = entry.Run.Options;
  vtkNew<vtkRenderWindow> window;
  widefov::OpenWindow(window);
  window->SetMultiSamples(0);
  window->SetSize(o.Size[0], o.Size[1]);
  vtkNew<vtkRenderer> renderer;
  for (std::size_t i = 0; i < scene.Scene.Props.size(); ++i)
  {
    renderer->AddActor(NumberActor(scene.Scene.Props[i].Surface, scene.FirstCells[i]));
  }
  const vtkSmartPointer<vtkPanoramicProjectionPass> pass = widefov::MakeCubeMapPass(o);
  pass->SetInterpolate(false);
  widefov::SetCubeMapPass(renderer, pass);
  widefov::SetCamera(renderer, scene.Scene, o);
  window->AddRenderer(renderer);
  window->Render();
  return ReadNumbers(window, o.Size[0], o.Size[1]);
}
}
}
