// SPDX-License-Identifier: BSD-3-Clause
#include "Dome.h"

#include "Options/Borders.h"
#include "Text/Angles.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>

#include <algorithm>
#include <cmath>

namespace widefov
{
namespace
{
constexpr int Steps = 160;          // of the grid, in both directions
constexpr double Inside = 1 - 1e-6; // NDC: the border belongs to no map for sure
constexpr double Neighbours = 0.35; // largest chord between the corners of a cell

// NDC of a place of the grid, from 0 to 1: of round maps the radius and the azimuth, so that the
// rim is a circle. That of a measured one is anywhere.
wfv::vec2 PlaceOf(const wfv::Projection& p, const wfv::ViewOptions& o, double across, double along)
{
  if (p.Axis != wfv::Family::Azimuthal || o.Measured.IsSet())
  {
    return { Inside * (2 * across - 1), Inside * (2 * along - 1) };
  }
  const double radius = Inside * across;
  const double azimuth = 360 * Degree * along;
  return { radius * std::cos(azimuth) / std::max(1.0, o.Aspect),
    radius * std::sin(azimuth) * std::min(1.0, o.Aspect) };
}

double Chord(const wfv::vec3& a, const wfv::vec3& b)
{
  return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z);
}

bool AreNeighbours(const wfv::ViewRay* const (&corners)[4])
{
  for (int i = 0; i < 4; i++)
  {
    const wfv::ViewRay& next = *corners[(i + 1) % 4];
    if (!corners[i]->Inside || Chord(corners[i]->Direction, next.Direction) > Neighbours)
    {
      return false;
    }
  }
  return true;
}
}

vtkSmartPointer<vtkPolyData> MakeDome(const Options& o)
{
  const wfv::Projection& p = *wfv::FindProjection(o.Projection);
  wfv::ViewOptions options = o.View;
  options.Stereo.Model = nullptr; // the eye between both
  const wfv::View view(p, options);
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> places;
  places->SetNumberOfComponents(2);
  std::vector<wfv::ViewRay> rays;
  for (int i = 0; i <= Steps * (Steps + 2); i++)
  {
    const wfv::vec2 ndc =
      PlaceOf(p, options, double(i % (Steps + 1)) / Steps, double(i / (Steps + 1)) / Steps);
    rays.push_back(view.Ray(InWhole(o, ndc)));
    const wfv::vec3& d = rays.back().Direction;
    points->InsertNextPoint(d.x, d.y, d.z);
    places->InsertNextTuple2(0.5 * (ndc.x + 1), 0.5 * (ndc.y + 1));
  }
  vtkNew<vtkCellArray> cells;
  for (int i = 0; i < Steps * (Steps + 1); i++)
  {
    const vtkIdType ids[4] = { i, i + 1, i + Steps + 2, i + Steps + 1 };
    const bool last = i % (Steps + 1) == Steps; // of its row
    if (!last && AreNeighbours({ &rays[ids[0]], &rays[ids[1]], &rays[ids[2]], &rays[ids[3]] }))
    {
      cells->InsertNextCell(4, ids);
    }
  }
  auto dome = vtkSmartPointer<vtkPolyData>::New();
  dome->SetPoints(points);
  dome->SetPolys(cells);
  dome->GetPointData()->SetTCoords(places);
  return dome;
}

vtkSmartPointer<vtkPolyData> MakeScreen(const wfv::Screen& c)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> places;
  places->SetNumberOfComponents(2);
  const wfv::vec3 corners[4] = { c.LowerLeft, c.LowerRight, c.UpperRight,
    c.LowerLeft + c.UpperRight - c.LowerRight };
  const double across[4] = { 0, 1, 1, 0 };
  const double up[4] = { 0, 0, 1, 1 };
  for (int i = 0; i < 4; i++)
  {
    points->InsertNextPoint(corners[i].x, corners[i].y, corners[i].z);
    places->InsertNextTuple2(across[i], up[i]);
  }
  vtkNew<vtkCellArray> cells;
  const vtkIdType ids[4] = { 0, 1, 2, 3 };
  cells->InsertNextCell(4, ids);
  auto screen = vtkSmartPointer<vtkPolyData>::New();
  screen->SetPoints(points);
  screen->SetPolys(cells);
  screen->GetPointData()->SetTCoords(places);
  return screen;
}
}
