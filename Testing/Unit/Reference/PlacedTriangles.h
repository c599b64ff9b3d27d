// SPDX-License-Identifier: BSD-3-Clause
// Triangles given by their places in a picture of everything, for tests of what is seen beside a
// pixel.
#ifndef WideFoVPlacedTriangles_h
#define WideFoVPlacedTriangles_h

#include "RayCaster.h"

#include <array>

namespace wfv
{
namespace test
{
constexpr int PlacedWidth = 1024;
constexpr int PlacedHeight = 512;

inline View WholeSphere()
{
  ViewOptions o;
  o.Radii = { { 0.1, 100 } };
  return View(*FindProjection("equirectangular"), o);
}

class PlacedTriangles
{
public:
  // A cell of its own; each corner so far from the eye, scene units.
  void Add(const std::array<double, 3>& distances, const std::array<vec2, 3>& places)
  {
    const vtkIdType first = vtkIdType(this->Soup.Points.size());
    for (std::size_t i = 0; i < 3; ++i)
    {
      const ViewRay ray = WholeSphere().Ray(
        reference::PixelToNdc(places[i].x, places[i].y, PlacedWidth, PlacedHeight));
      this->Soup.Points.push_back(ray.Direction * distances[i]);
    }
    this->Soup.CellIds.push_back(vtkIdType(this->Soup.Triangles.size()));
    this->Soup.Triangles.push_back({ { first, first + 1, first + 2 } });
  }

  // All corners at one distance.
  void Add(double distance, const std::array<vec2, 3>& places)
  {
    this->Add({ { distance, distance, distance } }, places);
  }

  reference::TriangleSoup Soup;
};
}
}

#endif
