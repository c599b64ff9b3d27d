// SPDX-License-Identifier: BSD-3-Clause
#include "Camera/NearThings.h"

#include "Camera/PropBounds.h"
#include "Drawables/Kinds/DrawableKinds.h"

#include "vtkActor.h"
#include "vtkAssemblyNode.h"
#include "vtkAssemblyPath.h"
#include "vtkCellArray.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkIdList.h"
#include "vtkLine.h"
#include "vtkMapper.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
// Cells or points of a mesh that are measured: 3 ms.
constexpr vtkIdType MostMeasured = 100000;

// The step between the cells that are measured.
vtkIdType StepOf(vtkIdType count)
{
  return 1 + count / MostMeasured;
}

double DistanceToSegment(const double eye[3], const double* a, const double* b)
{
  double along;
  double closest[3];
  return std::sqrt(vtkLine::DistanceToLine(eye, a, b, along, closest));
}

double DistanceToTriangle(const double eye[3], const double* const corners[3])
{
  double edges[3][3];
  double normal[3];
  for (int i = 0; i < 3; i++)
  {
    vtkMath::Subtract(corners[(i + 1) % 3], corners[i], edges[i]);
  }
  vtkMath::Cross(edges[0], edges[1], normal);
  bool above = vtkMath::Normalize(normal) > 0;
  double distance = std::numeric_limits<double>::infinity();
  double height = 0;
  for (int i = 0; i < 3; i++)
  {
    double way[3];
    double side[3];
    vtkMath::Subtract(eye, corners[i], way);
    vtkMath::Cross(edges[i], way, side);
    above = above && vtkMath::Dot(side, normal) >= 0;
    height = vtkMath::Dot(way, normal);
    distance = std::min(distance, DistanceToSegment(eye, corners[i], corners[(i + 1) % 3]));
  }
  return above ? std::min(distance, std::abs(height)) : distance;
}

// How the points of a cell hang together.
enum class Cell
{
  Points,
  Line,
  Polygon,
  Strip
};

// Distance at which a triangle counts as touching the eye, as a fraction of the eye's largest
// coordinate. Coordinates may be rounded to float, so the triangle has no near part to lose.
constexpr double AtEye = 1e-7;

// Measures the distances of one eye.
class Ruler
{
public:
  Ruler(const double eye[3], double within, const wfv::NearThings::SeenTest& isSeen)
    : Nearest(within)
    , Within(within)
    , IsSeen(isSeen)
  {
    std::copy_n(eye, 3, this->Eye);
  }

  void MeasureProp(vtkProp* prop);

  // The least distance so far; never more than the one to begin with.
  double Nearest;

private:
  void MeasureActor(vtkActor* actor, vtkMatrix4x4* matrix);
  void MeasureData(vtkDataObject* data, bool pointsAlone);
  void MeasurePoints(vtkDataSet* data);
  void MeasureCells(vtkPolyData* data, vtkCellArray* cells, Cell kind);
  void MeasureParts(int points, Cell kind);
  void Measure(const double* a, const double* b, const double* c);
  bool IsNearer(const double bounds[6]);
  void Place(vtkDataSet* data, vtkIdType point, double place[3]);

  double Eye[3];
  double Within;
  const wfv::NearThings::SeenTest& IsSeen;
  vtkMatrix4x4* Matrix = nullptr; // of the data that are measured
  vtkNew<vtkIdList> Ids;
  std::vector<double> Corners;
};

// Tests whether a box may have something nearer, in a place that the view may show.
bool Ruler::IsNearer(const double bounds[6])
{
  if (!(wfv::DistanceToBox(this->Eye, bounds) < this->Nearest))
  {
    return false;
  }
  double part[6];
  for (int i = 0; i < 3; i++)
  {
    part[2 * i] = std::max(bounds[2 * i], this->Eye[i] - this->Within);
    part[2 * i + 1] = std::min(bounds[2 * i + 1], this->Eye[i] + this->Within);
  }
  return this->IsSeen(part);
}

void Ruler::Place(vtkDataSet* data, vtkIdType point, double place[3])
{
  double p[4] = { 0, 0, 0, 1 };
  data->GetPoint(point, p);
  if (this->Matrix)
  {
    this->Matrix->MultiplyPoint(p, p);
  }
  std::copy_n(p, 3, place);
}

// Measures a triangle, a segment (c is b) or a point (all are one).
void Ruler::Measure(const double* a, const double* b, const double* c)
{
  double bounds[6];
  for (int i = 0; i < 3; i++)
  {
    bounds[2 * i] = std::min({ a[i], b[i], c[i] });
    bounds[2 * i + 1] = std::max({ a[i], b[i], c[i] });
  }
  if (!this->IsNearer(bounds))
  {
    return;
  }
  const double* const corners[3] = { a, b, c };
  const double distance =
    b == c ? DistanceToSegment(this->Eye, a, b) : DistanceToTriangle(this->Eye, corners);
  const double farthest =
    std::max({ std::abs(this->Eye[0]), std::abs(this->Eye[1]), std::abs(this->Eye[2]) });
  if (distance > AtEye * farthest)
  {
    this->Nearest = std::min(this->Nearest, distance);
  }
}

// Measures the cell whose points were placed.
void Ruler::MeasureParts(int points, Cell kind)
{
  const int most = kind == Cell::Points ? 1 : kind == Cell::Line ? 2 : 3; // points of a part
  const int size = std::min(points, most);
  const auto corner = [this](int i) { return &this->Corners[3 * static_cast<std::size_t>(i)]; };
  for (int first = 0; first + size <= points; first++)
  {
    const int a = kind == Cell::Polygon ? 0 : first;
    const int b = size > 1 ? first + 1 : a;
    this->Measure(corner(a), corner(b), corner(size > 2 ? first + 2 : b));
  }
}

void Ruler::MeasureCells(vtkPolyData* data, vtkCellArray* cells, Cell kind)
{
  const vtkIdType count = cells ? cells->GetNumberOfCells() : 0;
  const vtkIdType step = StepOf(count);
  for (vtkIdType cell = 0; cell < count; cell += step)
  {
    cells->GetCellAtId(cell, this->Ids);
    const int points = static_cast<int>(this->Ids->GetNumberOfIds());
    this->Corners.resize(3 * static_cast<std::size_t>(points));
    for (int i = 0; i < points; i++)
    {
      this->Place(data, this->Ids->GetId(i), &this->Corners[3 * static_cast<std::size_t>(i)]);
    }
    if (points > 0)
    {
      this->MeasureParts(points, kind);
    }
  }
}

void Ruler::MeasurePoints(vtkDataSet* data)
{
  const vtkIdType count = data->GetNumberOfPoints();
  const vtkIdType step = StepOf(count);
  double place[3];
  for (vtkIdType point = 0; point < count; point += step)
  {
    this->Place(data, point, place);
    this->Measure(place, place, place);
  }
}

void Ruler::MeasureData(vtkDataObject* data, bool pointsAlone)
{
  if (auto* const composite = vtkCompositeDataSet::SafeDownCast(data))
  {
    const auto it = vtk::TakeSmartPointer(composite->NewIterator());
    for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
    {
      this->MeasureData(it->GetCurrentDataObject(), pointsAlone);
    }
    return;
  }
  auto* const mesh = pointsAlone ? nullptr : vtkPolyData::SafeDownCast(data);
  if (mesh)
  {
    this->MeasureCells(mesh, mesh->GetVerts(), Cell::Points);
    this->MeasureCells(mesh, mesh->GetLines(), Cell::Line);
    this->MeasureCells(mesh, mesh->GetPolys(), Cell::Polygon);
    this->MeasureCells(mesh, mesh->GetStrips(), Cell::Strip);
  }
  else if (auto* const points = vtkDataSet::SafeDownCast(data))
  {
    this->MeasurePoints(points);
  }
}

void Ruler::MeasureActor(vtkActor* actor, vtkMatrix4x4* matrix)
{
  vtkMapper* const mapper = actor->GetMapper();
  if (mapper && actor->GetVisibility() && mapper->GetNumberOfInputConnections(0) > 0)
  {
    this->Matrix = matrix;
    const bool pointsAlone =
      wfv::HasTrait(mapper, wfv::PointsAlone) || wfv::HasTrait(mapper, wfv::CopiesAtPoints);
    this->MeasureData(mapper->GetInputDataObject(0, 0), pointsAlone);
  }
}

void Ruler::MeasureProp(vtkProp* prop)
{
  if (auto* const actor = vtkActor::SafeDownCast(prop))
  {
    this->MeasureActor(actor, actor->GetMatrix());
    return;
  }
  bool ofActors = false;
  prop->InitPathTraversal();
  while (vtkAssemblyPath* const path = prop->GetNextPath())
  {
    vtkAssemblyNode* const node = path->GetLastNode();
    if (auto* const actor = vtkActor::SafeDownCast(node->GetViewProp()))
    {
      this->MeasureActor(actor, node->GetMatrix());
      ofActors = true;
    }
  }
  // nothing but its bounds is known of anything else, and nothing if the eye is in these
  double bounds[6];
  if (!ofActors && wfv::FindLastBounds(prop, bounds) && wfv::DistanceToBox(this->Eye, bounds) > 0 &&
    this->IsNearer(bounds))
  {
    this->Nearest = wfv::DistanceToBox(this->Eye, bounds);
  }
}
}

namespace wfv
{
void NearThings::Begin(const double eye[3], double within)
{
  this->Asked = { eye[0], eye[1], eye[2], within };
  this->Candidates.clear();
}

void NearThings::Add(vtkRenderer* renderer)
{
  vtkPropCollection* const props = renderer->GetViewProps();
  vtkCollectionSimpleIterator it;
  props->InitTraversal(it);
  while (vtkProp* const prop = props->GetNextProp(it))
  {
    double bounds[6];
    if (prop->GetVisibility() && prop->GetUseBounds() && FindLastBounds(prop, bounds) &&
      vtkMath::AreBoundsInitialized(bounds) &&
      DistanceToBox(this->Asked.data(), bounds) < this->Asked[3])
    {
      this->Candidates.push_back({ prop, prop->GetRedrawMTime() });
    }
  }
}

double NearThings::Find(const SeenTest& isSeen)
{
  if (this->Candidates == this->LastCandidates && this->Asked == this->LastAsked)
  {
    return this->Found;
  }
  Ruler ruler(this->Asked.data(), this->Asked[3], isSeen);
  for (const Candidate& candidate : this->Candidates)
  {
    ruler.MeasureProp(candidate.Prop);
  }
  this->Found =
    ruler.Nearest < this->Asked[3] ? ruler.Nearest : std::numeric_limits<double>::infinity();
  this->LastAsked = this->Asked;
  this->LastCandidates = this->Candidates;
  return this->Found;
}
}
