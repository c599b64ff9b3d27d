// SPDX-License-Identifier: BSD-3-Clause
#include "CellFiles.h"

#include <vtkCamera.h>
#include <vtkCellData.h>
#include <vtkImageData.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>
#include <vtkXMLPolyDataReader.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

using namespace wfv;

namespace
{
int ReadNumber(const unsigned char* colour)
{
  return 65536 * colour[0] + 256 * colour[1] + colour[2];
}
}

namespace checkcells
{
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

reference::Pose MakePose(const std::array<double, 3>& eye, const std::array<double, 3>& focal,
  const std::array<double, 3>& up)
{
  vtkNew<vtkCamera> camera;
  camera->SetPosition(eye.data());
  camera->SetFocalPoint(focal.data());
  camera->SetViewUp(up.data());
  reference::Pose pose;
  std::copy_n(camera->GetViewTransformMatrix()->GetData(), 16, pose.begin());
  return pose;
}

reference::TriangleSoup ReadSoup(const std::string& file, const reference::Pose& pose)
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
}
