// SPDX-License-Identifier: BSD-3-Clause
#include "EmptyFile.h"

#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>

namespace widefov
{
namespace
{
// Bytes: a file without points that is longer has many arrays, and is left to VTK's reader.
constexpr std::uintmax_t MostBytes = 1 << 16;

bool AnnouncesNoPoints(const std::string& path)
{
  std::error_code error;
  if (std::filesystem::file_size(path, error) > MostBytes || error)
  {
    return false;
  }
  std::ifstream file(path, std::ios::binary);
  const std::string text{ std::istreambuf_iterator<char>(file), {} };
  static const std::regex some("NumberOfPoints *= *[\"'] *0*[1-9]");
  static const std::regex grid("<(PolyData|UnstructuredGrid)[ />]");
  return std::regex_search(text, grid) && !std::regex_search(text, some);
}
}

vtkSmartPointer<vtkDataObject> EmptyData(const std::string& path, const std::string& ending)
{
  const bool surface = ending == ".vtp";
  if ((!surface && ending != ".vtu") || !AnnouncesNoPoints(path))
  {
    return nullptr;
  }
  return surface ? vtkSmartPointer<vtkDataObject>(vtkNew<vtkPolyData>())
                 : vtkSmartPointer<vtkDataObject>(vtkNew<vtkUnstructuredGrid>());
}
}
