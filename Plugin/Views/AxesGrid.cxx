// SPDX-License-Identifier: BSD-3-Clause
#include "AxesGrid.h"

#include "vtkActor.h"
#include "vtkAxis.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkContextScene.h"
#include "vtkDoubleArray.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <cmath>

namespace wfvplugin
{
namespace
{
// Pixels, on both sides of an axis, as of ParaView's own.
constexpr double MarkLength = 10;

// Of the box's size, for the direction that leads out of a face; and how long a mark may be.
constexpr double OutwardStep = 1e-3;
constexpr double LongestMark = 0.05;

// Of an edge, for its length in the picture.
constexpr int Pieces = 64;

// How far the edge's picture goes to the side and up, pixels.
std::array<double, 2> MeasureEdge(vtkRenderer* renderer, const GridBox& box, int axis, Point3 from)
{
  std::array<double, 2> all{};
  const auto at = [&](int i) {
    from[axis] = box.GetMinimum(axis) + box.GetSize(axis) * i / Pieces;
    return box.ToWorld(from);
  };
  for (int i = 0; i < Pieces; i++)
  {
    double way[2];
    if (FindWay(renderer, at(i), at(i + 1), way))
    {
      all[0] += std::abs(way[0]);
      all[1] += std::abs(way[1]);
    }
  }
  return all;
}

// The longest of the four edges along an axis.
std::array<double, 2> MeasureAxis(vtkRenderer* renderer, const GridBox& box, int axis)
{
  std::array<double, 2> longest{};
  for (int i = 0; i < 4; i++)
  {
    const int next = (axis + 1) % 3;
    const int last = (axis + 2) % 3;
    Point3 from;
    from[next] = i & 1 ? box.GetMaximum(next) : box.GetMinimum(next);
    from[last] = i & 2 ? box.GetMaximum(last) : box.GetMinimum(last);
    const auto edge = MeasureEdge(renderer, box, axis, from);
    if (std::hypot(edge[0], edge[1]) > std::hypot(longest[0], longest[1]))
    {
      longest = edge;
    }
  }
  return longest;
}
}

AxesGrid::AxesGrid(GridAxesActor* stock)
  : Stock(stock)
{
  vtkNew<vtkPolyDataMapper> mapper;
  this->Lines->SetMapper(mapper);
  this->Lines->UseBoundsOff();
  this->Lines->PickableOff();
  for (auto& axis : this->Axes)
  {
    axis->SetScene(this->Scene);
    axis->SetBehavior(vtkAxis::FIXED);
  }
}

AxesGrid::~AxesGrid()
{
  if (this->Renderer)
  {
    this->Renderer->RemoveViewProp(this->Lines);
  }
}

vtkProp* AxesGrid::GetStock() const
{
  return this->Stock;
}

void AxesGrid::Show(vtkRenderer* renderer)
{
  if (!this->Renderer)
  {
    this->Renderer = renderer;
    renderer->AddViewProp(this->Lines);
  }
  this->Find(renderer);
  this->UpdateLines();
  this->Texts.Show(renderer, this->Labels, this->Stock->GetForceOpaque());
  this->Stock->VisibilityOff();
}

void AxesGrid::Hide()
{
  this->Lines->VisibilityOff();
  this->Texts.Hide();
  this->Stock->VisibilityOn();
}

void AxesGrid::Find(vtkRenderer* renderer)
{
  this->Points.clear();
  this->Labels.clear();
  Point3 eye;
  renderer->GetActiveCamera()->GetPosition(eye.data());
  const GridBox box(this->Stock, eye);
  this->FindTicks(renderer, box);
  for (const GridFace& face : box.GetFaces())
  {
    this->AddFace(box, face);
  }
  for (const GridEdge& edge : box.GetEdges())
  {
    if (box.GetSize(edge.Axis) > 0)
    {
      this->AddEdge(renderer, box, edge);
    }
  }
}

void AxesGrid::FindTicks(vtkRenderer* renderer, const GridBox& box)
{
  for (int i = 0; i < 3; i++)
  {
    Ticks& ticks = this->TicksOf[i];
    ticks.Places.clear();
    ticks.Texts.clear();
    const auto length = MeasureAxis(renderer, box, i);
    if (!(box.GetSize(i) > 0) || !(length[0] + length[1] > 0))
    {
      continue;
    }
    const bool level = length[0] > length[1];
    const auto pixels = static_cast<float>(std::hypot(length[0], length[1]));
    vtkAxis* const axis = this->Axes[i];
    axis->SetPosition(level ? vtkAxis::BOTTOM : vtkAxis::LEFT);
    axis->SetPoint1(0, 0);
    axis->SetPoint2(level ? pixels : 0, level ? 0 : pixels);
    axis->SetNotation(this->Stock->GetNotation(i));
    axis->SetPrecision(this->Stock->GetPrecision(i));
    axis->SetCustomTickPositions(GetCustomLabels(this->Stock, i));
    axis->SetUnscaledRange(box.GetMinimum(i), box.GetMaximum(i));
    axis->Update();
    for (vtkIdType n = 0; n < axis->GetTickPositions()->GetNumberOfTuples(); n++)
    {
      ticks.Places.push_back(axis->GetTickPositions()->GetValue(n));
      ticks.Texts.push_back(GetTickText(this->Stock, i, axis, n));
    }
  }
}

void AxesGrid::AddLine(const GridBox& box, const Point3& from, const Point3& to)
{
  this->Points.push_back(box.ToWorld(from));
  this->Points.push_back(box.ToWorld(to));
}

void AxesGrid::AddFace(const GridBox& box, const GridFace& face)
{
  for (int i = 1; i <= 2; i++)
  {
    const int along = (face.Axis + i) % 3;
    const int across = (face.Axis + 3 - i) % 3;
    Point3 from;
    from[face.Axis] = face.Side ? box.GetMaximum(face.Axis) : box.GetMinimum(face.Axis);
    from[along] = box.GetMinimum(along);
    Point3 to = from;
    to[along] = box.GetMaximum(along);
    const auto add = [&](double place) {
      from[across] = to[across] = place;
      this->AddLine(box, from, to);
    };
    if (this->Stock->GetGenerateEdges())
    {
      add(box.GetMinimum(across));
      add(box.GetMaximum(across));
    }
    if (this->Stock->GetGenerateGrid())
    {
      std::for_each(this->TicksOf[across].Places.begin(), this->TicksOf[across].Places.end(), add);
    }
  }
}

void AxesGrid::AddEdge(vtkRenderer* renderer, const GridBox& box, const GridEdge& edge)
{
  const double step = OutwardStep * box.GetSize(edge.Across);
  const auto beside = [&](double place, double by) {
    Point3 point = edge.From;
    point[edge.Axis] = place;
    point[edge.Across] += edge.Sign * by;
    return point;
  };
  const auto add = [&](double place, const std::string& text, double distance, bool mark,
                     vtkTextProperty* property) {
    PlacedLabel label{ box.ToWorld(beside(place, 0)), text, { 0, 0 }, distance, property };
    double way[2];
    if (FindWay(renderer, label.Place, box.ToWorld(beside(place, step)), way) &&
      std::hypot(way[0], way[1]) > 0)
    {
      const double length = std::hypot(way[0], way[1]);
      label.Outwards[0] = way[0] / length;
      label.Outwards[1] = way[1] / length;
      const double half =
        std::min(MarkLength * step / length, LongestMark * box.GetSize(edge.Across));
      if (mark)
      {
        this->AddLine(box, beside(place, -half), beside(place, half));
      }
    }
    this->Labels.push_back(label);
  };
  const Ticks& ticks = this->TicksOf[edge.Axis];
  for (std::size_t i = 0; i < ticks.Places.size(); i++)
  {
    add(ticks.Places[i], ticks.Texts[i], NumberDistance, this->Stock->GetGenerateTicks(),
      this->Stock->GetLabelTextProperty(edge.Axis));
  }
  add(box.GetMinimum(edge.Axis) + 0.5 * box.GetSize(edge.Axis), this->Stock->GetTitle(edge.Axis),
    TitleDistance, false, this->Stock->GetTitleTextProperty(edge.Axis));
}

void AxesGrid::UpdateLines()
{
  vtkProperty* const property = this->Stock->GetProperty();
  if (this->PropertyTime < property->GetMTime())
  {
    this->Lines->GetProperty()->DeepCopy(property);
    // which faces are drawn is decided; a line has no front and back
    this->Lines->GetProperty()->FrontfaceCullingOff();
    this->Lines->GetProperty()->BackfaceCullingOff();
    this->PropertyTime = property->GetMTime();
  }
  this->Lines->SetForceOpaque(this->Stock->GetForceOpaque());
  this->Lines->SetVisibility(!this->Points.empty());
  if (this->Points == this->Drawn)
  {
    return;
  }
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  for (std::size_t i = 0; i < this->Points.size(); i += 2)
  {
    const vtkIdType ids[2] = { points->InsertNextPoint(this->Points[i].data()),
      points->InsertNextPoint(this->Points[i + 1].data()) };
    lines->InsertNextCell(2, ids);
  }
  vtkNew<vtkPolyData> mesh;
  mesh->SetPoints(points);
  mesh->SetLines(lines);
  vtkPolyDataMapper::SafeDownCast(this->Lines->GetMapper())->SetInputData(mesh);
  this->Drawn = this->Points;
}
}
