// SPDX-License-Identifier: BSD-3-Clause
// Closed spheres round the eye.
#include "MeshBuilder.h"
#include "Scenes.h"
#include "Text/Angles.h"

#include <vtkFloatArray.h>
#include <vtkPlatonicSolidSource.h>
#include <vtkPointData.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace widefov
{
namespace
{

Vector3 PointOf(vtkPolyData* mesh, vtkIdType id)
{
  Vector3 p;
  mesh->GetPoint(id, p.data());
  return Unit(p);
}

// Splits every triangle into four; all new points lie on the unit sphere.
class Subdivision
{
public:
  explicit Subdivision(vtkPolyData* solid)
  {
    for (vtkIdType i = 0; i < solid->GetNumberOfPoints(); i++)
    {
      this->Points.push_back(PointOf(solid, i));
    }
    for (vtkIdType i = 0; i < solid->GetNumberOfCells(); i++)
    {
      vtkIdType count = 0;
      const vtkIdType* ids = nullptr;
      solid->GetPolys()->GetCellAtId(i, count, ids);
      this->Triangles.push_back({ { ids[0], ids[1], ids[2] } });
    }
  }

  void Split()
  {
    std::vector<std::array<vtkIdType, 3>> finer;
    this->Middles.clear();
    for (const auto& [a, b, c] : this->Triangles)
    {
      const vtkIdType ab = this->Middle(a, b);
      const vtkIdType bc = this->Middle(b, c);
      const vtkIdType ca = this->Middle(c, a);
      finer.push_back({ { a, ab, ca } });
      finer.push_back({ { ab, b, bc } });
      finer.push_back({ { ca, bc, c } });
      finer.push_back({ { ab, bc, ca } });
    }
    this->Triangles.swap(finer);
  }

  std::vector<Vector3> Points;
  std::vector<std::array<vtkIdType, 3>> Triangles;

private:
  vtkIdType Middle(vtkIdType a, vtkIdType b)
  {
    const auto [entry, isNew] = this->Middles.try_emplace(
      { std::min(a, b), std::max(a, b) }, static_cast<vtkIdType>(this->Points.size()));
    if (isNew)
    {
      this->Points.push_back(Unit(this->Points[a] + this->Points[b]));
    }
    return entry->second;
  }

  std::map<std::pair<vtkIdType, vtkIdType>, vtkIdType> Middles;
};

// Hue by longitude, lightness by latitude, in a 15 degree chequerboard.
Vector3 GlobeColor(double longitude, double latitude)
{
  const auto wave = [longitude](
                      double phase) { return 0.5 + 0.5 * std::cos((longitude - phase) * Degree); };
  const int parity = static_cast<int>(std::floor(longitude / 15) + std::floor(latitude / 15)) & 1;
  const double light = (0.55 + 0.4 * latitude / 90) * (parity == 0 ? 1 : 0.75);
  return { { light * (0.3 + 0.7 * wave(0)), light * (0.3 + 0.7 * wave(120)),
    light * (0.3 + 0.7 * wave(240)) } };
}
}

Scene MakeSphere()
{
  // seven splits of the icosahedron: the longest edge is 0.59 degrees
  constexpr int Splits = 7;
  vtkNew<vtkPlatonicSolidSource> solid;
  solid->SetSolidTypeToIcosahedron();
  solid->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  solid->Update();
  Subdivision sphere(solid->GetOutput());
  for (int i = 0; i < Splits; i++)
  {
    sphere.Split();
  }
  MeshBuilder mesh;
  for (const Vector3& p : sphere.Points)
  {
    const Vector3 color = Vector3{ { 0.5, 0.5, 0.5 } } + 0.45 * p;
    mesh.AddPoint(p, -1 * p, color);
  }
  for (const auto& [a, b, c] : sphere.Triangles)
  {
    mesh.AddTriangle(a, b, c);
  }
  Scene scene = ColoredScene("sphere", mesh.Build());
  scene.Eye = Vector3{ { 0, 0, 0 } };
  return scene;
}

Scene MakeGlobe()
{
  constexpr int Step = 3; // degrees; each 15 degree field is 5 x 5 tiles
  MeshBuilder mesh;
  vtkNew<vtkFloatArray> latitudes;
  latitudes->SetName("latitude");
  vtkNew<vtkFloatArray> longitudes;
  longitudes->SetName("longitude");
  const auto corner = [&](double lon, double lat, const Vector3& color) {
    const Vector3 p = DirectionOf(lon, lat);
    latitudes->InsertNextValue(static_cast<float>(lat));
    longitudes->InsertNextValue(static_cast<float>(lon));
    return mesh.AddPoint(p, -1 * p, color);
  };
  for (int lat = -90; lat < 90; lat += Step)
  {
    for (int lon = -180; lon < 180; lon += Step)
    {
      const Vector3 color = GlobeColor(lon + 0.5 * Step, lat + 0.5 * Step);
      const vtkIdType a = corner(lon, lat, color);
      const vtkIdType b = corner(lon + Step, lat, color);
      const vtkIdType c = corner(lon + Step, lat + Step, color);
      const vtkIdType d = corner(lon, lat + Step, color);
      if (lat > -90) // at a pole two of the corners are one point
      {
        mesh.AddTriangle(a, b, c);
      }
      if (lat + Step < 90)
      {
        mesh.AddTriangle(a, c, d);
      }
    }
  }
  Scene scene = ColoredScene("globe", mesh.Build());
  scene.Props[0].Surface->GetPointData()->AddArray(latitudes);
  scene.Props[0].Surface->GetPointData()->AddArray(longitudes);
  scene.Eye = Vector3{ { 0, 0, 0 } };
  return scene;
}
}
