// SPDX-License-Identifier: BSD-3-Clause
// Meshes for tests of bad ones, and every way in which they are drawn.
#ifndef BadMeshes_h
#define BadMeshes_h

#include "WideFoVTestScene.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkUnsignedCharArray.h"
#include "vtkWideFoVPolyDataMapper.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace badMesh
{
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinite = std::numeric_limits<double>::infinity();

using Corner = std::array<double, 3>;

struct Mesh
{
  std::vector<Corner> Points;
  std::vector<std::vector<vtkIdType>> Polygons;
  std::vector<std::vector<vtkIdType>> Strips;
};

inline vtkSmartPointer<vtkCellArray> CellsOf(const std::vector<std::vector<vtkIdType>>& cells)
{
  const auto array = vtkSmartPointer<vtkCellArray>::New();
  for (const std::vector<vtkIdType>& cell : cells)
  {
    array->InsertNextCell(static_cast<vtkIdType>(cell.size()), cell.data());
  }
  return array;
}

inline vtkSmartPointer<vtkPolyData> DataOf(const Mesh& mesh, int type = VTK_FLOAT)
{
  vtkNew<vtkPoints> points;
  points->SetDataType(type);
  for (const Corner& p : mesh.Points)
  {
    points->InsertNextPoint(p.data());
  }
  const auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(CellsOf(mesh.Polygons));
  data->SetStrips(CellsOf(mesh.Strips));
  return data;
}

inline Corner Round(double longitude, double latitude, double radius = 1)
{
  return { radius * std::cos(latitude) * std::sin(longitude), radius * std::sin(latitude),
    -radius * std::cos(latitude) * std::cos(longitude) };
}

// Triangles round the eye: `steps` times half as many squares of them, small at the poles.
inline Mesh MakeGlobe(int steps)
{
  Mesh mesh;
  const int rows = steps / 2;
  for (int j = 0; j <= rows; j++)
  {
    for (int i = 0; i <= steps; i++)
    {
      mesh.Points.push_back(Round(2 * M_PI * i / steps, M_PI * (j / double(rows) - 0.5)));
    }
  }
  for (vtkIdType j = 0; j < rows; j++)
  {
    for (vtkIdType i = 0; i < steps; i++)
    {
      const vtkIdType p = j * (steps + 1) + i;
      const vtkIdType up = p + steps + 1;
      mesh.Polygons.push_back({ p, p + 1, up + 1 });
      mesh.Polygons.push_back({ p, up + 1, up });
    }
  }
  return mesh;
}

struct Way
{
  int Technique = vtkWideFoVPass::AUTO;
  bool Own = true; // our mapper
  int Samples = 0;
  int Type = VTK_FLOAT; // of points

  std::string Name() const
  {
    return "technique " + std::to_string(this->Technique) + (this->Own ? ", own" : ", stock") +
      " mapper, samples " + std::to_string(this->Samples) + ", points of type " +
      std::to_string(this->Type);
  }
};

inline std::vector<Way> EveryWay()
{
  std::vector<Way> ways;
  // (the technique VERTEX clips nothing: there no number is a place like any other)
  for (const int technique : { vtkWideFoVPass::AUTO, vtkWideFoVPass::EXACT })
  {
    for (const bool own : { true, false })
    {
      ways.push_back({ technique, own, 0, VTK_FLOAT });
    }
  }
  ways.push_back({ vtkWideFoVPass::PRECLIP, true, 0, VTK_FLOAT });
  ways.push_back({ vtkWideFoVPass::AUTO, true, 4, VTK_FLOAT });
  ways.push_back({ vtkWideFoVPass::AUTO, true, 0, VTK_DOUBLE });
  ways.push_back({ vtkWideFoVPass::EXACT, true, 0, VTK_DOUBLE });
  return ways;
}

struct Scene
{
  Scene(const Way& way, vtkPolyData* data, const char* projection = "equirectangular")
    : Test(projection, 128, 64)
  {
    this->Test.Window->SetMultiSamples(way.Samples);
    this->Test.Renderer->SetBackground(0, 0, 0);
    this->Test.Pass()->SetTechnique(way.Technique);
    const auto mapper = way.Own
      ? vtkSmartPointer<vtkPolyDataMapper>(vtkSmartPointer<vtkWideFoVPolyDataMapper>::New())
      : vtkSmartPointer<vtkPolyDataMapper>(vtkSmartPointer<vtkOpenGLPolyDataMapper>::New());
    mapper->SetInputData(data);
    this->Actor->SetMapper(mapper);
    this->Actor->GetProperty()->SetColor(0.9, 0.7, 0.3);
    this->Test.Renderer->AddActor(this->Actor);
  }

  std::vector<unsigned char> Draw()
  {
    this->Test.Window->Render();
    return TestPixels(this->Test.Window).Copy();
  }

  WideFoVTestWindow Test;
  vtkNew<vtkActor> Actor;
};

inline int CountDrawn(const std::vector<unsigned char>& picture)
{
  int n = 0;
  for (size_t i = 0; i < picture.size(); i += 3)
  {
    n += picture[i] > 0;
  }
  return n;
}

inline int CountOthers(const std::vector<unsigned char>& a, const std::vector<unsigned char>& b)
{
  int n = 0;
  for (size_t i = 0; i < std::min(a.size(), b.size()); i += 3)
  {
    n += !std::equal(a.begin() + i, a.begin() + i + 3, b.begin() + i);
  }
  return n;
}
}

#endif
