// SPDX-License-Identifier: BSD-3-Clause
// Compares a picture of cells with the double-precision ray caster's.
//
//   widefov-check-cells REQUEST.json
//
// The request: {"mesh": FILE.vtp, "picture": FILE.png, "projection", "hfov", "vfov", "tilt"
// (degrees), "eye", "focal", "up" (world), "clip": [near, far], "tolerance" (pixels)}, and of
// one of two eyes "stereo": {"model", "side" (-1 left, 1 right), "ipd", "fade", "warped",
// "separation", "convergence"}, the numbers as of vtkWideFoVCamera's setters. A
// pixel's colour is the number that the mesh's cell array "number" gives the cell, 24 bits,
// red the highest; black is nothing.
// The answer, on standard output: {"pixels", "hits", "mismatched", "unexplained",
// "missing", "spurious"} in pixels, {"max_px"} and "worst", the first few of them.
#include "Metrics.h"
#include "RayCaster.h"
#include "Stereo.h"

#include <vtkCamera.h>
#include <vtkCellData.h>
#include <vtkImageData.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>
#include <vtkXMLPolyDataReader.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <iostream>
#include <limits>

using json = nlohmann::json;
using namespace wfv;

namespace
{
int ReadNumber(const unsigned char* colour)
{
  return 65536 * colour[0] + 256 * colour[1] + colour[2];
}

reference::DrawnPicture ReadPicture(const std::string& file)
{
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  vtkImageData* const image = reader->GetOutput();
  int size[3];
  image->GetDimensions(size);
  if (image->GetNumberOfScalarComponents() < 3 || size[0] < 1)
  {
    throw std::runtime_error("no picture of colours: " + file);
  }
  reference::DrawnPicture picture;
  picture.Width = size[0];
  picture.Height = size[1];
  for (int j = size[1] - 1; j >= 0; j--)
  {
    for (int i = 0; i < size[0]; i++)
    {
      const auto* c = static_cast<const unsigned char*>(image->GetScalarPointer(i, j, 0));
      const int cell = ReadNumber(c);
      picture.Cell.push_back(static_cast<float>(cell));
      // a screenshot has no distance
      picture.Distance.push_back(cell ? 1 : std::numeric_limits<float>::infinity());
    }
  }
  return picture;
}

StereoOptions MakeStereo(const json& stereo)
{
  StereoOptions o;
  o.Model = FindStereoModel(stereo.at("model"));
  if (!o.Model)
  {
    throw std::runtime_error("unknown stereo model");
  }
  o.Eye = static_cast<Eye>(stereo.at("side").get<int>());
  o.InterpupillaryDistance = stereo.at("ipd");
  o.PoleFade = stereo.at("fade");
  const auto warped = stereo.at("warped").get<std::array<double, 3>>();
  o.Iod = warped[0];
  o.Distance = warped[1];
  o.Offset = warped[2];
  o.Separation = stereo.at("separation");
  o.Convergence = stereo.at("convergence");
  return o;
}

View MakeView(const json& request, double aspect)
{
  const Projection* const projection = FindProjection(request.at("projection"));
  if (!projection)
  {
    throw std::runtime_error("unknown projection");
  }
  ViewOptions o;
  // as far as the projection can show them, as in the view
  o.HorizontalFov = std::clamp(
    request.at("hfov").get<double>(), projection->MinHorizontalFov, projection->MaxHorizontalFov);
  o.VerticalFov = std::clamp(
    request.at("vfov").get<double>(), projection->MinVerticalFov, projection->MaxVerticalFov);
  o.Tilt = request.value("tilt", 0.0);
  o.Radii = request.at("clip");
  o.Aspect = aspect;
  if (request.contains("stereo"))
  {
    o.Stereo = MakeStereo(request.at("stereo"));
  }
  const std::string wrong = CheckOptions(*projection, o);
  if (!wrong.empty())
  {
    throw std::runtime_error(wrong);
  }
  return View(*projection, o);
}

reference::Pose MakePose(const json& request)
{
  vtkNew<vtkCamera> camera;
  camera->SetPosition(request.at("eye").get<std::array<double, 3>>().data());
  camera->SetFocalPoint(request.at("focal").get<std::array<double, 3>>().data());
  camera->SetViewUp(request.at("up").get<std::array<double, 3>>().data());
  reference::Pose pose;
  std::copy_n(camera->GetViewTransformMatrix()->GetData(), 16, pose.begin());
  return pose;
}

// The triangles of the mesh, each with its cell's number less one for an id.
reference::TriangleSoup MakeSoup(const std::string& file, const reference::Pose& pose)
{
  vtkNew<vtkXMLPolyDataReader> mesh;
  mesh->SetFileName(file.c_str());
  mesh->Update();
  auto* const numbers =
    vtkUnsignedCharArray::SafeDownCast(mesh->GetOutput()->GetCellData()->GetArray("number"));
  if (!numbers || numbers->GetNumberOfComponents() != 3)
  {
    throw std::runtime_error("no cell array \"number\" of colours: " + file);
  }
  reference::TriangleSoup soup = reference::Triangulate(mesh->GetOutput(), pose);
  for (vtkIdType& id : soup.CellIds)
  {
    id = ReadNumber(numbers->GetPointer(3 * id)) - 1;
  }
  if (!std::is_sorted(soup.CellIds.begin(), soup.CellIds.end()))
  {
    throw std::runtime_error("the numbers of the cells do not grow: " + file);
  }
  return soup;
}

json Describe(const reference::WorstPixel& pixel)
{
  return { { "x", pixel.I }, { "y", pixel.J }, { "drawn", pixel.Drawn },
    { "reference", pixel.Reference }, { "px", pixel.Pixels } };
}

json Check(const json& request)
{
  const reference::DrawnPicture drawn = ReadPicture(request.at("picture"));
  const View view = MakeView(request, static_cast<double>(drawn.Width) / drawn.Height);
  const reference::RayCaster caster(MakeSoup(request.at("mesh"), MakePose(request)), view);
  const reference::HitPicture truth = caster.Render(drawn.Width, drawn.Height);
  // more mismatches than this are a broken picture, whose every pixel need not be searched
  constexpr std::size_t MostSearched = 300;
  const reference::Metrics m =
    reference::Compare(drawn, caster, truth, request.at("tolerance"), MostSearched);
  const double pixels = static_cast<double>(drawn.Width) * drawn.Height;
  json worst = json::array();
  for (std::size_t i = 0; i < std::min<std::size_t>(5, m.Worst.size()); i++)
  {
    worst.push_back(Describe(m.Worst[i]));
  }
  const long hits = std::count_if(
    truth.Hits.begin(), truth.Hits.end(), [](const reference::Hit& hit) { return hit.Cell >= 0; });
  return { { "pixels", pixels }, { "hits", hits }, { "mismatched", m.Mismatched },
    { "unexplained", m.Unexplained * pixels }, { "missing", m.Missing * pixels },
    { "spurious", m.Spurious * pixels }, { "max_px", m.MaxPx }, { "worst", worst } };
}
}

int main(int argc, char* argv[])
{
  if (argc != 2)
  {
    std::cerr << "widefov-check-cells: name the request\n";
    return 2;
  }
  try
  {
    std::ifstream in(argv[1]);
    std::cout << Check(json::parse(in)) << std::endl;
  }
  catch (const std::exception& e)
  {
    std::cerr << "widefov-check-cells: " << e.what() << "\n";
    return 1;
  }
  return 0;
}
