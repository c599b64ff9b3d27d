// SPDX-License-Identifier: BSD-3-Clause
// Flat screens of a CAVE against rays known in closed form: from the eye through the place of the
// pixel on the screen.
#include "Meshes.h"
#include "Metrics.h"
#include "Stereo/Screen.h"
#include "vtkWideFoVDataPass.h"
#include "vtkWideFoVPass.h"
#include "vtkWideFoVScreenCamera.h"

#include <vtkActor.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <vector>

using namespace wfv;
using namespace wfv::test;

namespace
{
// Pixels: float32 vertices, and the hundredth of a pixel that a rasterizer places them to.
constexpr double ScreenTolerance = 0.02;

// Pixels: how far the pictures of a line may be apart where two screens meet.
constexpr double ScreenEdgeTolerance = 0.05;

// Relative error of the distance along the pixel's ray.
constexpr double ScreenDepthTolerance = 1e-5;

// Scene units, of places on screens a few units away, in double.
constexpr double PlaceRounding = 1e-12;

constexpr int Side = 256;  // pixels of a screen
constexpr int Lines = 512; // and where lines are measured, from all columns

// A CAVE of four walls: left, front, right, floor. Room coordinates.
const std::vector<Screen> Cave{ { { -1.5, -1, 1.5 }, { -1.5, -1, -1.5 }, { -1.5, 2, -1.5 } },
  { { -1.5, -1, -1.5 }, { 1.5, -1, -1.5 }, { 1.5, 2, -1.5 } },
  { { 1.5, -1, -1.5 }, { 1.5, -1, 1.5 }, { 1.5, 2, 1.5 } },
  { { -1.5, -1, 1.5 }, { 1.5, -1, 1.5 }, { 1.5, -1, -1.5 } } };

Head Standing(const vec3& at, const std::array<double, 4>& turn = { { 0, 0, 0, 1 } })
{
  Head head;
  head.Position = at;
  head.Turn = turn;
  return head;
}

// At rest, and moved and turned.
const std::vector<Head> Heads{ Standing({ 0, 0, 0 }),
  Standing({ 0.4, 0.6, -0.7 }, { { 0, 0.5, 0, 0.8 } }),
  Standing({ -1.1, 1.3, 0.9 }, { { 0.3, -0.6, 0.2, 0.7 } }) };

// The place in the room of a place in a screen's picture, 0 to 1 from the lower left.
vec3 PlaceOn(const Screen& s, double x, double y)
{
  return s.LowerLeft + x * (s.LowerRight - s.LowerLeft) + y * (s.UpperRight - s.LowerRight);
}

// A window with a mesh round the room, which stands askew in the scene.
class Cinema
{
public:
  Cinema()
  {
    this->Window->SetOffScreenRendering(1);
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(Side, Side);
    this->Window->AddRenderer(this->Renderer);
    this->Renderer->SetActiveCamera(this->Camera);
    this->Actor->SetMapper(this->Mapper);
    this->Renderer->AddActor(this->Actor);
    this->Data->SetDelegatePass(this->Pass);
    this->Data->SetPropIndex(this->Actor, 0);
    this->Renderer->SetPass(this->Data);
    this->Camera->SetPosition(0.2, -0.3, 0.1);
    this->Camera->SetFocalPoint(1.2, 0.1, -0.9);
    this->Camera->SetViewUp(0.1, 1, 0.2);
    this->Camera->SetInterpupillaryDistance(0.2);
  }

  reference::DrawnPicture Draw(const Screen& screen, const Head& head, Eye eye)
  {
    this->Camera->SetScreen(&screen.LowerLeft.x, &screen.LowerRight.x, &screen.UpperRight.x);
    this->Camera->SetHeadPosition(head.Position.x, head.Position.y, head.Position.z);
    this->Camera->SetHeadTurn(head.Turn[0], head.Turn[1], head.Turn[2], head.Turn[3]);
    this->Window->SetStereoType(eye == Eye::Left ? VTK_STEREO_LEFT : VTK_STEREO_RIGHT);
    this->Window->SetStereoRender(eye != Eye::Middle);
    this->Window->Render();
    return reference::ToDrawnPicture(this->Data->GetOutput());
  }

  // A place of the room in the scene, by vector algebra alone.
  vec3 ToWorld(const vec3& room) const
  {
    const vec3 at(0.2, -0.3, 0.1);
    const vec3 ahead = glm::normalize(vec3(1.2, 0.1, -0.9) - at);
    const vec3 right = glm::normalize(glm::cross(ahead, vec3(0.1, 1, 0.2)));
    return at + room.x * right + room.y * glm::cross(right, ahead) - room.z * ahead;
  }

  reference::Pose GetPose() const
  {
    reference::Pose pose;
    std::copy_n(this->Camera->GetModelViewTransformMatrix()->GetData(), 16, pose.begin());
    return pose;
  }

  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkWideFoVScreenCamera> Camera;
  vtkNew<vtkPolyDataMapper> Mapper;
  vtkNew<vtkActor> Actor;
  vtkNew<vtkWideFoVPass> Pass;
  vtkNew<vtkWideFoVDataPass> Data;
};

const std::vector<Eye> AllEyes{ Eye::Left, Eye::Middle, Eye::Right };

// Where the eye of a head is: said here once more, with a rotation matrix.
vec3 EyeIn(const Head& head, Eye eye, double ipd)
{
  const double n = std::sqrt(head.Turn[0] * head.Turn[0] + head.Turn[1] * head.Turn[1] +
    head.Turn[2] * head.Turn[2] + head.Turn[3] * head.Turn[3]);
  const double y = head.Turn[1] / n;
  const double z = head.Turn[2] / n;
  const double x = head.Turn[0] / n;
  const double w = head.Turn[3] / n;
  const vec3 right(1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y));
  return head.Position + 0.5 * ipd * static_cast<double>(eye) * right;
}
}

// The camera's rays are those from the eye through the places of the screen, and a point of the
// scene is seen at the place where the line to it passes through the screen, whatever the head.
TEST(CompareScreens, RaysPassThroughTheScreen)
{
  Cinema cinema;
  for (const Screen& screen : Cave)
  {
    for (const Head& head : Heads)
    {
      for (const Eye side : AllEyes)
      {
        cinema.Draw(screen, head, side);
        const vec3 eye = cinema.ToWorld(EyeIn(head, side, 0.2));
        for (int i = 0; i < 25; i++)
        {
          const double x = 0.25 * (i % 5);
          const double y = 0.25 * (i / 5);
          const vec3 place = cinema.ToWorld(PlaceOn(screen, x, y));
          const double ndc[2] = { 2 * x - 1, 2 * y - 1 };
          vec3 origin, direction;
          ASSERT_TRUE(cinema.Camera->NDCToRay(ndc, 1, &origin.x, &direction.x));
          EXPECT_LE(glm::length(origin - eye), PlaceRounding);
          EXPECT_LE(glm::length(direction - glm::normalize(place - eye)), PlaceRounding);
          const vec3 point = eye + 3.7 * (place - eye);
          double seen[3];
          cinema.Camera->WorldToNDC(&point.x, 1, seen);
          EXPECT_LE(std::hypot(seen[0] - ndc[0], seen[1] - ndc[1]), PlaceRounding);
        }
      }
    }
  }
}

TEST(CompareScreens, PicturesAreThoseOfTheRayCaster)
{
  Cinema cinema;
  const vtkSmartPointer<vtkPolyData> mesh = MakeGlobe(12, { vec3(0.3, -0.2, 0.1), 4 });
  cinema.Mapper->SetInputData(mesh);
  for (std::size_t s = 0; s < Cave.size(); s++)
  {
    for (const Head& head : Heads)
    {
      for (const Eye side : AllEyes)
      {
        const reference::DrawnPicture picture = cinema.Draw(Cave[s], head, side);
        ASSERT_EQ(picture.Width, Side);
        const reference::RayCaster caster(mesh, cinema.Camera->GetView(1), cinema.GetPose());
        const reference::Metrics m = reference::Compare(picture, caster, ScreenTolerance);
        EXPECT_EQ(m.UnexplainedPixels, 0)
          << "screen " << s << " eye " << static_cast<int>(side) << " max " << m.MaxPx << " px";
        EXPECT_LE(m.MaxDepthRel, ScreenDepthTolerance) << "screen " << s;
        EXPECT_GT(m.DomainPixels, 0);
      }
    }
  }
}

namespace
{
// Two triangles that meet in a long line through the room, on a plane across it.
vtkSmartPointer<vtkPolyData> MakeBorder(const vec3& from, const vec3& to, const vec3& side)
{
  reference::TriangleSoup soup;
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  for (const vec3& p : { from, to, 0.5 * (from + to) + side, 0.5 * (from + to) - side })
  {
    points->InsertNextPoint(p.x, p.y, p.z);
  }
  const vtkIdType triangles[2][3] = { { 0, 1, 2 }, { 1, 0, 3 } };
  cells->InsertNextCell(3, triangles[0]);
  cells->InsertNextCell(3, triangles[1]);
  mesh->SetPoints(points);
  mesh->SetPolys(cells);
  return mesh;
}

// The heights, in rows from the top, between which a straight line must lie at x = 0, so that the
// pixel centres of each column are on the sides that were drawn.
struct Band
{
  double Low = -1e9;
  double High = 1e9;
};

struct Column
{
  double X;   // pixels from the shared edge
  double Low; // the line passes between these two rows' centres
  double High;
};

Band BandAt(const std::vector<Column>& columns, double slope)
{
  Band band;
  for (const Column& c : columns)
  {
    band.Low = std::max(band.Low, c.Low - slope * c.X);
    band.High = std::min(band.High, c.High - slope * c.X);
  }
  return band;
}

// Over all slopes that leave a band at all, by a fine search round that between the outer columns.
Band Fit(const std::vector<Column>& columns)
{
  Band all{ 1e9, -1e9 };
  const Column& first = columns.front();
  const Column& last = columns.back();
  const double slope = (last.Low - first.Low) / (last.X - first.X);
  for (int i = -20000; i <= 20000; i++)
  {
    const Band band = BandAt(columns, slope + 1e-6 * i);
    if (band.Low <= band.High)
    {
      all.Low = std::min(all.Low, band.Low);
      all.High = std::max(all.High, band.High);
    }
  }
  return all;
}

// Where a column of the picture changes from one of the two triangles to the other.
std::vector<Column> Changes(const reference::DrawnPicture& p, bool edgeOnTheRight)
{
  std::vector<Column> columns;
  for (int i = 0; i < p.Width; i++)
  {
    for (int j = 0; j + 1 < p.Height; j++)
    {
      const float above = p.Cell[std::size_t(j) * p.Width + i];
      const float below = p.Cell[std::size_t(j + 1) * p.Width + i];
      if (above > 0 && below > 0 && above != below)
      {
        columns.push_back({ i + 0.5 - (edgeOnTheRight ? p.Width : 0), j + 0.5, j + 1.5 });
      }
    }
  }
  return columns;
}
}

// Straight lines of the room that pass the upright edge between the left and the front wall: their
// pictures on both meet there, and where the closed form says.
TEST(CompareScreens, LinesContinueAcrossEdges)
{
  Cinema cinema;
  cinema.Window->SetSize(Lines, Lines);
  for (int line = 0; line < 6; line++)
  {
    const vec3 from(-3.5, -0.6 + 0.35 * line, 2.2 - 0.1 * line);
    const vec3 to(3.2, 1.3 - 0.2 * line, -4.1 + 0.2 * line);
    cinema.Mapper->SetInputData(MakeBorder(cinema.ToWorld(from), cinema.ToWorld(to),
      cinema.ToWorld({ 0, 3, 0 }) - cinema.ToWorld({ 0, 0, 0 })));
    const Head head = Standing({ 0.3, 0.4, 0.5 });
    const Band left = Fit(Changes(cinema.Draw(Cave[0], head, Eye::Middle), true));
    const Band front = Fit(Changes(cinema.Draw(Cave[1], head, Eye::Middle), false));
    // the plane of the eye and the line meets the edge x = z = -1.5 at this height
    const vec3 normal = glm::cross(from - head.Position, to - head.Position);
    const vec3 foot = vec3(-1.5, 0, -1.5) - head.Position;
    const double height = -glm::dot(normal, foot) / normal.y;
    const double row = Lines * (2 - height) / 3;
    std::cout << "line " << line << ": row " << row << ", left " << left.Low << " to " << left.High
              << ", front " << front.Low << " to " << front.High << std::endl;
    for (const Band& band : { left, front })
    {
      ASSERT_LE(band.Low, band.High) << "no straight line fits what was drawn";
      EXPECT_GE(band.Low, row - ScreenEdgeTolerance) << line;
      EXPECT_LE(band.High, row + ScreenEdgeTolerance) << line;
    }
    EXPECT_LE(std::max(left.High - front.Low, front.High - left.Low), ScreenEdgeTolerance);
  }
}
