// SPDX-License-Identifier: BSD-3-Clause
#include "WideFoVTestScene.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkConeSource.h"
#include "vtkCubeSource.h"
#include "vtkElevationFilter.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkPNGReader.h"
#include "vtkPNGWriter.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRegressionTestImage.h"
#include "vtkTriangleFilter.h"
#include "vtkUnsignedCharArray.h"
#include "vtkWindowToImageFilter.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <string>

WideFoVTestWindow::WideFoVTestWindow(const char* projection, int width, int height)
{
  this->Camera->SetProjection(projection);
  this->Camera->SetPosition(0.1, 0.05, 0.07);
  this->Camera->SetFocalPoint(0.1, 0.05, -1);
  this->Renderer->SetActiveCamera(this->Camera);
  this->Renderer->SetBackground(0.1, 0.1, 0.12);
  this->Window->SetOffScreenRendering(1);
  this->Window->SetMultiSamples(0);
  this->Window->SetSize(width, height);
  this->Window->AddRenderer(this->Renderer);
}

vtkSmartPointer<vtkActor> MakeTestActor(vtkAlgorithm* source, double r, double g, double b)
{
  vtkNew<vtkOpenGLPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(r, g, b);
  return actor;
}

vtkSmartPointer<vtkActor> MakeTestRoom()
{
  vtkNew<vtkCubeSource> cube;
  cube->SetXLength(4);
  cube->SetYLength(3);
  cube->SetZLength(5);
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(cube->GetOutputPort());
  vtkNew<vtkElevationFilter> height;
  height->SetInputConnection(triangles->GetOutputPort());
  height->SetLowPoint(-2, -1.5, -2.5);
  height->SetHighPoint(2, 1.5, 2.5);
  return MakeTestActor(height, 1, 1, 1);
}

void AddTestCones(vtkRenderer* renderer)
{
  for (int i = 0; i < 8; i++)
  {
    const double a = i * vtkMath::Pi() / 4 + 0.1;
    vtkNew<vtkConeSource> cone;
    cone->SetResolution(40);
    cone->SetHeight(0.8);
    cone->SetRadius(0.3);
    cone->SetCenter(1.5 * std::cos(a), 0.3 * (i % 3) - 0.3, 1.5 * std::sin(a));
    renderer->AddActor(MakeTestActor(cone, 1, i / 8.0, 0.2));
  }
}

vtkSmartPointer<vtkPolyData> MakeGraticule(double radius, double step, bool coarse)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  const double fine = coarse ? 45 : 2;
  const auto add = [&](double lambda, double phi) {
    const double l = vtkMath::RadiansFromDegrees(lambda);
    const double p = vtkMath::RadiansFromDegrees(phi);
    lines->InsertCellPoint(points->InsertNextPoint(radius * std::cos(p) * std::sin(l),
      radius * std::sin(p), -radius * std::cos(p) * std::cos(l)));
  };
  for (double lambda = -180; lambda < 180; lambda += step)
  {
    const int n = static_cast<int>(180 / fine);
    lines->InsertNextCell(n + 1);
    for (int i = 0; i <= n; i++)
    {
      add(lambda, -90 + i * fine);
    }
  }
  for (double phi = -90 + step; phi < 90; phi += step)
  {
    const int n = static_cast<int>(360 / fine);
    lines->InsertNextCell(n + 1);
    for (int i = 0; i <= n; i++)
    {
      add(i * fine + 7, phi); // not symmetric to the seam
    }
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetLines(lines);
  return data;
}

namespace
{
// VTK's comparison forgives a shift of a pixel and adds up what is left, so a picture that is
// darker all over may pass. So: how far a colour may be off, of 255, and the share of pixels that
// may be off by more: rasterizers place edges differently.
constexpr int ColorTolerance = 2;
constexpr double ShareOfOthers = 0.001;

// Pixels of another colour than in the file; 1 where there is no such file of this size.
double ShareOfOthersIn(const TestPixels& drawn, const std::string& file)
{
  vtkNew<vtkPNGReader> reader;
  if (!reader->CanReadFile(file.c_str()))
  {
    return 1;
  }
  reader->SetFileName(file.c_str());
  reader->Update();
  vtkImageData* const image = reader->GetOutput();
  const int* const size = image->GetDimensions();
  if (size[0] != drawn.Width || size[1] != drawn.Height)
  {
    return 1;
  }
  long others = 0;
  for (int i = 0; i < size[0] * size[1]; i++)
  {
    const int x = i % size[0];
    const int y = i / size[0];
    const auto* wanted = static_cast<const unsigned char*>(image->GetScalarPointer(x, y, 0));
    const unsigned char* const at = drawn.At(x, y);
    const auto isOff = [&](int c) { return std::abs(at[c] - wanted[c]) > ColorTolerance; };
    others += isOff(0) || isOff(1) || isOff(2);
  }
  return double(others) / (double(size[0]) * size[1]);
}

// The value of an option of VTK's test drivers; empty without it.
std::string ValueOf(const char* option, int argc, char* argv[])
{
  const auto at = std::find(argv, argv + argc, std::string(option));
  return argv + argc - at > 1 ? at[1] : "";
}

// Of the baselines of a test, NAME.png, NAME_1.png and so on, the one that is nearest.
double ShareOfOtherColors(const TestPixels& drawn, const std::filesystem::path& baseline)
{
  const std::string stem = (baseline.parent_path() / baseline.stem()).string();
  double least = ShareOfOthersIn(drawn, baseline.string());
  for (int i = 1; std::filesystem::exists(stem + "_" + std::to_string(i) + ".png"); i++)
  {
    least = std::min(least, ShareOfOthersIn(drawn, stem + "_" + std::to_string(i) + ".png"));
  }
  return least;
}

void WritePicture(vtkRenderWindow* window, const std::filesystem::path& file)
{
  vtkNew<vtkWindowToImageFilter> grab;
  grab->SetInput(window);
  grab->ReadFrontBufferOff();
  vtkNew<vtkPNGWriter> writer;
  writer->SetFileName(file.string().c_str());
  writer->SetInputConnection(grab->GetOutputPort());
  writer->Write();
  std::cout << "what was drawn: " << file.string() << "\n";
}
}

int CompareWithBaseline(vtkRenderWindow* window, int argc, char* argv[])
{
  window->Render();
  const bool passed = vtkRegressionTestImage(window) == vtkRegressionTester::PASSED;
  const std::filesystem::path baseline = ValueOf("-V", argc, argv);
  const double others = ShareOfOtherColors(TestPixels(window), baseline);
  std::cout << "pixels whose colour is off by more than " << ColorTolerance
            << " of 255: " << 100 * others << " %, at most " << 100 * ShareOfOthers << " %\n";
  if (others > ShareOfOthers)
  {
    WritePicture(window, std::filesystem::path(ValueOf("-T", argc, argv)) / baseline.filename());
    return EXIT_FAILURE;
  }
  return passed ? EXIT_SUCCESS : EXIT_FAILURE;
}

TestPixels::TestPixels(vtkRenderWindow* window)
  : Width(window->GetSize()[0])
  , Height(window->GetSize()[1])
  , Data(vtkSmartPointer<vtkUnsignedCharArray>::New())
{
  window->GetPixelData(0, 0, this->Width - 1, this->Height - 1, 0, this->Data);
}

const unsigned char* TestPixels::At(int x, int y) const
{
  return this->Data->GetPointer(3 * (static_cast<vtkIdType>(y) * this->Width + x));
}

std::vector<unsigned char> TestPixels::Copy() const
{
  const unsigned char* const first = this->At(0, 0);
  return { first, first + this->Data->GetNumberOfValues() };
}
