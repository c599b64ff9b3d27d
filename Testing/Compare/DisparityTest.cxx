// SPDX-License-Identifier: BSD-3-Clause
// Where the drawn pictures of both eyes show upright edges all round, against the closed form:
// an edge at the longitude lambda and the horizontal distance d is seen by the eye s at
// lambda - s asin(r / d), whatever the latitude. Edges are put 0.02 pixels beside pixel centres,
// on either side, so one picture says on which side of it the edge is drawn.
#include "DrawingTest.h"
#include "Stereo/Stereo.h"
#include "vtkWideFoVPass.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <iostream>

using namespace wfv;
using namespace wfv::test;

namespace
{
constexpr int DisparityWidth = 720;
constexpr int DisparityHeight = 360;
constexpr double Distance = 0.2; // between the eyes, scene units

// Pixels: how far an edge may be from where the closed form has it.
constexpr double DisparityTolerance = 0.02;

// Degrees: as near to the poles as this.
constexpr double NearestPole = 5;

const double Degree = WFV_PI / 180;

struct Edge
{
  int Column;      // of the pixel it is beside
  double Distance; // horizontal
};

// In front, at the sides, behind, beside the seam; near and far.
std::vector<Edge> Edges()
{
  const double distances[] = { 0.5, 1, 3, 0.7 };
  std::vector<Edge> edges;
  for (int i = 0; i < 12; i++)
  {
    edges.push_back({ 2 + 60 * i, distances[i % 4] });
  }
  return edges;
}

// Where an edge must be, so that the eye s sees it so many pixels to the right of its pixel.
double LongitudeOf(const Edge& edge, int s, double offset)
{
  const double seen = ((edge.Column + 0.5 + offset) / DisparityWidth - 0.5) * 2 * WFV_PI;
  return seen + s * std::asin(0.5 * Distance / edge.Distance);
}

// Two upright walls that meet at each edge: cells 2 k on its left and 2 k + 1 on its right.
vtkSmartPointer<vtkPolyData> MakeWalls(const std::vector<Edge>& edges, int s, double offset)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  const auto add = [&](const vec3& p) { return points->InsertNextPoint(p.x, p.y, p.z); };
  for (const Edge& edge : edges)
  {
    const double lambda = LongitudeOf(edge, s, offset);
    const double high = 2 * edge.Distance * std::tan((90 - NearestPole) * Degree);
    const vec3 ahead(std::sin(lambda), 0, -std::cos(lambda));
    const vec3 right(std::cos(lambda), 0, std::sin(lambda));
    const vec3 at = edge.Distance * ahead;
    for (int side = -1; side <= 1; side += 2)
    {
      const vec3 end = at + 0.12 * edge.Distance * double(side) * right;
      cells->InsertNextCell(4);
      cells->InsertCellPoint(add(at - vec3(0, high, 0)));
      cells->InsertCellPoint(add(end - vec3(0, high, 0)));
      cells->InsertCellPoint(add(end + vec3(0, high, 0)));
      cells->InsertCellPoint(add(at + vec3(0, high, 0)));
    }
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(cells);
  return mesh;
}

// Checks one eye; returns how many pixels were looked at.
int Check(Drawing& drawing, int s, double offset)
{
  const std::vector<Edge> edges = Edges();
  drawing.SetMesh(MakeWalls(edges, s, offset));
  Shot shot;
  shot.Width = DisparityWidth;
  shot.Height = DisparityHeight;
  shot.Options.Radii = { { 0.1, 200 } };
  shot.Options.Stereo.Model = FindStereoModel("omnidirectional");
  shot.Options.Stereo.Eye = s < 0 ? Eye::Left : Eye::Right;
  shot.Options.Stereo.InterpupillaryDistance = Distance;
  const reference::DrawnPicture picture = drawing.Draw(shot);
  int looked = 0;
  for (std::size_t k = 0; k < edges.size(); k++)
  {
    // right of the pixel's centre the edge leaves the left wall to it
    const double expected = double(2 * k) + (offset > 0 ? 0 : 1) + 1;
    for (int j = 0; j < DisparityHeight; j++)
    {
      const double latitude = 90 - (j + 0.5) * 180 / DisparityHeight;
      if (std::abs(latitude) < 90 - NearestPole)
      {
        EXPECT_EQ(picture.Cell[j * DisparityWidth + edges[k].Column], expected)
          << "eye " << s << " edge " << k << " offset " << offset << " latitude " << latitude;
        looked++;
      }
    }
  }
  return looked;
}
}

TEST(Disparity, OfUprightEdgesIsTheClosedForm)
{
  Drawing drawing;
  for (const int technique : { vtkWideFoVPass::EXACT, vtkWideFoVPass::AUTO })
  {
    drawing.SetTechnique(technique);
    int looked = 0;
    for (const int s : { -1, 1 })
    {
      for (const double offset : { -DisparityTolerance, DisparityTolerance })
      {
        looked += Check(drawing, s, offset);
      }
    }
    std::cout << looked << " pixels beside edges looked at" << std::endl;
    EXPECT_EQ(looked, 4 * 12 * 340);
  }
}
