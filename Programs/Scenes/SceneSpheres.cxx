// SPDX-License-Identifier: BSD-3-Clause
// Closed spheres round the eye.
#include "MeshBuilder.h"
#include "Scenes.h"
#include "Text/Angles.h"

#include <vtkFloatArray.h>
#include <vtkPointData.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace widefov
{
namespace
{
// The icosahedron, wound so that its inside is seen from the front; by no source of VTK, whose
// winding differs from version to version. Sides of a golden rectangle, halved.
constexpr double Long = 0.5;
constexpr double Short = 0.30901699437494745;
constexpr std::array<Vector3, 12> Corners{ {
  { { 0, Short, -Long } },
  { { 0, Short, Long } },
  { { 0, -Short, Long } },
  { { -Short, Long, 0 } },
  { { -Short, -Long, 0 } },
  { { Short, Long, 0 } },
  { { Short, -Long, 0 } },
  { { 0, -Short, -Long } },
  { { Long, 0, Short } },
  { { -Long, 0, Short } },
  { { -Long, 0, -Short } },
  { { Long, 0, -Short } },
} };
constexpr vtkIdType Faces[20][3] = { { 0, 5, 3 }, { 1, 3, 5 }, { 1, 2, 9 }, { 1, 8, 2 },
  { 0, 7, 11 }, { 0, 10, 7 }, { 2, 6, 4 }, { 7, 4, 6 }, { 3, 9, 10 }, { 4, 10, 9 }, { 5, 11, 8 },
  { 6, 8, 11 }, { 1, 9, 3 }, { 1, 5, 8 }, { 0, 3, 10 }, { 0, 11, 5 }, { 7, 10, 4 }, { 7, 6, 11 },
  { 2, 4, 9 }, { 2, 8, 6 } };

// Splits every triangle into four; all new points lie on the unit sphere.
class Subdivision
{
public:
  Subdivision()
  {
    for (const Vector3& corner : Corners)
    {
      this->Points.push_back(Unit(corner));
    }
    for (const auto& face : Faces)
    {
      this->Triangles.push_back({ { face[0], face[1], face[2] } });
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
  Subdivision sphere;
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
