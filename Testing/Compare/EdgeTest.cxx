// SPDX-License-Identifier: BSD-3-Clause
// Surfaces with edges: how much of the edge colour a pixel shows follows from its distance, in
// the map, from the great circles of the edges of the cell that it sees, by the ray caster and
// the projection in double. Edges inside a polygon do not count.
#include "DrawingTest.h"
#include "LineReference.h"
#include "Meshes.h"
#include "RayCaster.h"
#include "vtkWideFoVPass.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <algorithm>
#include <iostream>

using namespace wfv;
using namespace wfv::test;

namespace
{
// Pixels, of the distance of an edge: one is the step from no edge colour to the full one.
constexpr double EdgeTolerance = 0.02;

// Pixels: how far a triangle may be from where it is seen by the ray caster.
constexpr double ExactSlack = 0.02;
constexpr double ChordSlack = 0.25;

// Line widths, pixels. One is 1.1 for stock VTK.
constexpr double Widths[] = { 1.5, 4 };
constexpr double Widest = 4;

// Radians by which edges are carried on: pixels inside a triangle may be nearer to the great
// circle of an edge than to the edge.
constexpr double BeyondLine = 0.5;

// The room as six polygons, which the mapper draws as two triangles each.
vtkSmartPointer<vtkPolyData> MakeBox()
{
  vtkNew<vtkPoints> points;
  for (int i = 0; i < 8; i++)
  {
    points->InsertNextPoint(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
  }
  const vtkIdType sides[6][4] = { { 0, 1, 3, 2 }, { 4, 6, 7, 5 }, { 0, 4, 5, 1 }, { 2, 3, 7, 6 },
    { 0, 2, 6, 4 }, { 1, 5, 7, 3 } };
  vtkNew<vtkCellArray> cells;
  for (const auto& side : sides)
  {
    cells->InsertNextCell(4, side);
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(cells);
  return mesh;
}

// White, unlit, with red edges: the green that is missing is the edges' share.
vtkSmartPointer<vtkActor> MakeActor(vtkPolyData* mesh, double width)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(mesh);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  vtkProperty* property = actor->GetProperty();
  property->SetAmbient(1);
  property->SetDiffuse(0);
  property->SetColor(1, 1, 1);
  property->SetEdgeColor(1, 0, 0);
  property->EdgeVisibilityOn();
  property->SetLineWidth(static_cast<float>(width));
  return actor;
}

// True where edge k, from corner k to the next, is an edge of the cell and not one inside
// the fan that it is drawn as.
bool IsOwn(const reference::TriangleSoup& soup, std::size_t triangle, int k)
{
  const vtkIdType cell = soup.CellIds[triangle];
  const bool first = triangle == 0 || soup.CellIds[triangle - 1] != cell;
  const bool last = triangle + 1 == soup.CellIds.size() || soup.CellIds[triangle + 1] != cell;
  return k == 1 || (k == 0 ? first : last);
}

// The edge of two corners as a line at distance 1, carried on both ways.
reference::Segment CarryOn(const vec3& p, const vec3& q, vtkIdType id)
{
  const vec3 u = glm::normalize(p);
  const vec3 v = glm::normalize(q - u * glm::dot(u, q));
  const double span = std::atan2(glm::dot(v, q), glm::dot(u, q));
  const auto at = [&](double a) { return std::cos(a) * u + std::sin(a) * v; };
  return { at(-BeyondLine), at(span + BeyondLine), id };
}

// Of each pixel, the edges near it, numbered 3 x triangle + k.
reference::LinePicture NearEdges(
  const reference::TriangleSoup& soup, const View& view, const Shot& shot, double reach)
{
  std::vector<reference::Segment> segments;
  for (std::size_t t = 0; t < soup.Triangles.size(); t++)
  {
    for (int k = 0; k < 3; k++)
    {
      if (IsOwn(soup, t, k))
      {
        segments.push_back(CarryOn(soup.Points[soup.Triangles[t][k]],
          soup.Points[soup.Triangles[t][(k + 1) % 3]], vtkIdType(3 * t + k)));
      }
    }
  }
  return reference::RenderLines(segments, view, shot.Width, shot.Height, reach);
}

struct EdgeResult
{
  long Pixels = 0; // that show some edge
  long Wrong = 0;
  double Worst = 0;
  std::string First;
};

class EdgeCheck
{
public:
  EdgeCheck(const reference::RayCaster& caster, const Shot& shot)
    : TheCaster(caster)
    , TheShot(shot)
    , Near(NearEdges(caster.GetTriangles(), caster.GetView(), shot, 0.5 * Widest + 1))
  {
  }

  EdgeResult Check(vtkImageData* image, double width, double slack);

private:
  // The edges' share of a pixel that sees this triangle.
  double Share(long key, vtkIdType triangle) const;

  // How far a share is from what is right for one of the triangles seen within the slack.
  double Off(int i, int j, double share) const;

  const reference::RayCaster& TheCaster;
  const Shot& TheShot;
  reference::LinePicture Near;
  double Width = 1;
  double Slack = 0;
};

double EdgeCheck::Share(long key, vtkIdType triangle) const
{
  const auto found = this->Near.find(key);
  double distance = 1e9;
  for (const reference::NearLine& line :
    found == this->Near.end() ? std::vector<reference::NearLine>() : found->second)
  {
    distance = line.Cell / 3 == triangle ? std::min(distance, line.Distance) : distance;
  }
  return std::min(1.0, std::max(0.0, 0.5 + 0.5 * this->Width - distance));
}

double EdgeCheck::Off(int i, int j, double share) const
{
  const Shot& s = this->TheShot;
  const long key = long(j) * s.Width + i;
  double least = 1e9;
  for (int n = 0; n < 17 && least > EdgeTolerance; n++)
  {
    const double r = this->Slack * ((n + 7) / 8) / 2;
    const double a = WFV_PI * n / 4;
    const vec2 ndc = reference::PixelToNdc(
      i + 0.5 + r * std::cos(a), j + 0.5 + r * std::sin(a), s.Width, s.Height);
    const reference::Hit hit = this->TheCaster.Cast(ndc);
    if (hit.Triangle >= 0)
    {
      least = std::min(least, std::abs(share - this->Share(key, hit.Triangle)));
    }
  }
  return least;
}

EdgeResult EdgeCheck::Check(vtkImageData* image, double width, double slack)
{
  this->Width = width;
  this->Slack = slack;
  const Shot& s = this->TheShot;
  vtkDataArray* color = image->GetPointData()->GetArray("color");
  EdgeResult result;
  for (long key = 0; key < long(s.Width) * s.Height; key++)
  {
    const int i = int(key % s.Width);
    const int j = int(key / s.Width);
    bool inside = false;
    // beside a curved border the nearest point of an edge may lie beyond it
    if (!reference::IsClear(
          this->TheCaster.GetView(), i, j, s.Width, s.Height, this->Width + 1, inside) ||
      !inside)
    {
      continue;
    }
    const double share = 1 - color->GetComponent(long(s.Height - 1 - j) * s.Width + i, 1);
    const double off = this->Off(i, j, share);
    result.Pixels += share > 0;
    result.Worst = std::max(result.Worst, off);
    if (off > EdgeTolerance)
    {
      result.Wrong++;
      const std::string what = std::to_string(i) + ", " + std::to_string(j) + ": share " +
        std::to_string(share) + " off by " + std::to_string(off);
      result.First = result.First.empty() ? what : result.First;
    }
  }
  return result;
}
}

class CompareEdges : public DrawingTest
{
protected:
  Shot MakeShot(int width) const
  {
    const Projection& p = *FindProjection(this->GetParam());
    Shot shot;
    shot.Projection = p.Name;
    shot.Width = width;
    shot.Height = width / 2;
    shot.Options.HorizontalFov = p.MaxHorizontalFov;
    shot.Options.VerticalFov = p.MaxVerticalFov;
    shot.Options.Radii = { { 0.01, 10 } };
    shot.Eye = vec3(0.1, 0.17, -0.13);
    return shot;
  }

  void CheckMesh(vtkPolyData* mesh, const std::string& name, int size = 512)
  {
    const Shot shot = this->MakeShot(size);
    std::unique_ptr<reference::RayCaster> caster;
    std::unique_ptr<EdgeCheck> check;
    for (int technique : { vtkWideFoVPass::EXACT, vtkWideFoVPass::PRECLIP })
    {
      for (double width : Widths)
      {
        Picture->SetActor(MakeActor(mesh, width));
        Picture->SetTechnique(technique);
        ASSERT_EQ(Picture->Draw(shot).Width, shot.Width) << "nothing was drawn: " << Describe(shot);
        if (!check)
        {
          caster.reset(new reference::RayCaster(mesh, Picture->GetView(), Picture->GetPose()));
          check.reset(new EdgeCheck(*caster, shot));
        }
        const double slack = technique == vtkWideFoVPass::EXACT ? ExactSlack : ChordSlack;
        const EdgeResult r = check->Check(Picture->GetImage(), width, slack);
        std::cout << shot.Projection << " " << name << " technique " << technique << " width "
                  << width << ": " << r.Pixels << " pixels of edges, " << r.Wrong
                  << " wrong, worst " << r.Worst << std::endl;
        EXPECT_GT(r.Pixels, 0);
        EXPECT_EQ(r.Wrong, 0) << name << " " << Describe(shot) << "\n  " << r.First;
      }
    }
  }
};

TEST_P(CompareEdges, BoxOfPolygons)
{
  this->CheckMesh(MakeBox(), "box");
}

TEST_P(CompareEdges, Globe)
{
  this->CheckMesh(MakeGlobe(6), "globe");
}

// Triangles as large as pixels: of each, all edges are near.
TEST_P(CompareEdges, FineGlobe)
{
  this->CheckMesh(MakeGlobe(16), "fine globe", 128);
}

INSTANTIATE_TEST_SUITE_P(All, CompareEdges,
  ::testing::Values("equirectangular", "hammer", "azimuthal-equidistant", "equi-angular-cubemap"),
  DrawingTest::NameOf);
