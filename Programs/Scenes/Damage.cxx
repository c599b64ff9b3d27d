// SPDX-License-Identifier: BSD-3-Clause
#include "Damage.h"

#include "Datasets.h"
#include "NetCdfHeader.h"
#include "PlyFile.h"

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace widefov
{
namespace
{
// Offsets that never fall and stay within the connectivity, ids that are points.
std::string DamagedCellArray(vtkCellArray* cells, vtkIdType points)
{
  if (cells == nullptr)
  {
    return "";
  }
  vtkDataArray* const offsets = cells->GetOffsetsArray();
  vtkDataArray* const ids = cells->GetConnectivityArray();
  double before = 0;
  for (vtkIdType i = 0; i < offsets->GetNumberOfValues(); i++)
  {
    const double offset = offsets->GetTuple1(i);
    if (!(offset >= before && offset <= static_cast<double>(ids->GetNumberOfValues())))
    {
      return "the size of cell " + std::to_string(i) + " is wrong";
    }
    before = offset;
  }
  for (vtkIdType i = 0; i < ids->GetNumberOfValues(); i++)
  {
    const double id = ids->GetTuple1(i);
    if (!(id >= 0 && id < static_cast<double>(points)))
    {
      return "a cell uses the point " + std::to_string(static_cast<long long>(id)) +
        ", but there are " + std::to_string(points) + " points, counted from 0";
    }
  }
  return "";
}

std::string DamagedLeaf(vtkDataSet* leaf)
{
  const vtkIdType points = leaf->GetNumberOfPoints();
  std::vector<vtkCellArray*> arrays;
  if (vtkPolyData* const surface = vtkPolyData::SafeDownCast(leaf))
  {
    arrays = { surface->GetVerts(), surface->GetLines(), surface->GetPolys(),
      surface->GetStrips() };
  }
  if (vtkUnstructuredGrid* const grid = vtkUnstructuredGrid::SafeDownCast(leaf))
  {
    arrays = { grid->GetCells() };
  }
  for (vtkCellArray* const cells : arrays)
  {
    const std::string damage = DamagedCellArray(cells, points);
    if (!damage.empty())
    {
      return damage;
    }
  }
  return "";
}
}

std::string DamagedCells(vtkDataObject* data)
{
  for (const auto& leaf : Leaves(data))
  {
    const std::string damage = DamagedLeaf(leaf);
    if (!damage.empty())
    {
      return damage;
    }
  }
  return "";
}

namespace
{
std::string DamagedStl(const std::string& path)
{
  constexpr std::uintmax_t HeaderSize = 84; // bytes: text, then the number of triangles
  constexpr std::uintmax_t TriangleSize = 50;
  std::array<unsigned char, HeaderSize> header{};
  std::ifstream file(path, std::ios::binary);
  file.read(reinterpret_cast<char*>(header.data()), header.size());
  const auto got = static_cast<std::uintmax_t>(file.gcount());
  const std::string start(header.begin(), header.begin() + 5);
  const bool text = start == "solid" &&
    std::find(header.begin(), header.begin() + static_cast<std::ptrdiff_t>(got), '\n') !=
      header.begin() + static_cast<std::ptrdiff_t>(got);
  if (text)
  {
    return ""; // VTK's own parser complains
  }
  if (got < HeaderSize)
  {
    return "it ends within its header";
  }
  const std::uintmax_t triangles = header[80] + (header[81] << 8) + (header[82] << 16) +
    (static_cast<std::uintmax_t>(header[83]) << 24);
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (size < HeaderSize + TriangleSize * triangles)
  {
    return "it announces " + std::to_string(triangles) + " triangles but holds at most " +
      std::to_string((size - HeaderSize) / TriangleSize);
  }
  return "";
}

// Numbers may touch ("1.0E+00-2.0E+00"), so they are parsed, not split at blanks.
std::string DamagedByu(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  const std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  const char* at = text.c_str();
  std::array<double, 4> header{}; // parts, vertices, polygons, entries of the polygons
  double wanted = header.size();
  double found = 0;
  for (char* end = nullptr; found < wanted; at = end, found++)
  {
    const double value = std::strtod(at, &end);
    if (end == at)
    {
      return found < header.size() ? "it does not begin with four numbers"
                                   : "it holds fewer numbers than it announces";
    }
    if (found < header.size())
    {
      header[static_cast<std::size_t>(found)] = value;
      if (!(value >= 0) || value > static_cast<double>(text.size()))
      {
        return "its first numbers are no counts";
      }
      wanted = header.size() + 2 * header[0] + 3 * header[1] + header[3];
    }
  }
  return "";
}

std::string DamagedXml(const std::string& path)
{
  const std::string tail = "</VTKFile>";
  constexpr std::streamoff Window = 256; // bytes; blanks may follow the end
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  const std::streamoff size = file.tellg();
  file.seekg(std::max<std::streamoff>(0, size - Window));
  std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  text.erase(text.find_last_not_of(" \t\r\n") + 1);
  const bool whole =
    text.size() >= tail.size() && text.compare(text.size() - tail.size(), tail.size(), tail) == 0;
  return whole ? "" : "it does not end with " + tail;
}
}

std::string DamagedFile(const std::string& path, const std::string& ending)
{
  if (ending == ".stl")
  {
    return DamagedStl(path);
  }
  if (ending == ".g")
  {
    return DamagedByu(path);
  }
  if (ending == ".ply")
  {
    return DamagedPly(path);
  }
  if (ending == ".nc" || ending == ".cdf" || ending == ".ex2")
  {
    return DamagedNetCdf(path);
  }
  return ending.size() == 4 && ending.compare(0, 3, ".vt") == 0 && ending != ".vtk"
    ? DamagedXml(path)
    : "";
}

std::string WarningOfDamage(const std::vector<std::string>& warnings)
{
  for (const std::string& warning : warnings)
  {
    std::string lower = warning;
    std::transform(lower.begin(), lower.end(), lower.begin(),
      [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    for (const char* const sign : { "error reading", "premature", "end of file", "eof" })
    {
      if (lower.find(sign) != std::string::npos)
      {
        return warning;
      }
    }
  }
  return "";
}
}
