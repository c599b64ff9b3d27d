// SPDX-License-Identifier: BSD-3-Clause
#include "VectorField.h"

#include "Datasets.h"
#include "Text/Messages.h"

#include <vtkAppendPolyData.h>
#include <vtkArrowSource.h>
#include <vtkBoundingBox.h>
#include <vtkCellDataToPointData.h>
#include <vtkClipPolyData.h>
#include <vtkDataSet.h>
#include <vtkFloatArray.h>
#include <vtkGlyph3D.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkSphere.h>
#include <vtkStreamTracer.h>
#include <vtkStripper.h>
#include <vtkTubeFilter.h>

#include <algorithm>
#include <cmath>

namespace widefov
{
namespace
{
bool Usable(const double v[3])
{
  return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]);
}

// The dataset itself, or with its cell arrays averaged to the points.
vtkSmartPointer<vtkDataSet> WithPointArray(vtkDataSet* data, const std::string& array)
{
  if (data->GetPointData()->GetArray(array.c_str()) != nullptr)
  {
    return data;
  }
  vtkNew<vtkCellDataToPointData> average;
  average->SetInputData(data);
  average->Update();
  return average->GetOutput();
}

// Every `stride`-th usable point with a vector that is not zero.
vtkSmartPointer<vtkPolyData> ThinnedPoints(
  vtkDataSet* data, const std::string& array, vtkIdType stride)
{
  vtkNew<vtkPolyData> thinned;
  vtkNew<vtkPoints> points;
  vtkDataArray* const vectors = data->GetPointData()->GetArray(array.c_str());
  if (vectors == nullptr || vectors->GetNumberOfComponents() != 3)
  {
    return thinned;
  }
  thinned->GetPointData()->CopyAllocate(data->GetPointData());
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); i += stride)
  {
    double p[3];
    double v[3];
    data->GetPoint(i, p);
    vectors->GetTuple(i, v);
    const double length = std::hypot(v[0], v[1], v[2]);
    if (Usable(p) && Usable(v) && length > 0)
    {
      thinned->GetPointData()->CopyData(data->GetPointData(), i, points->InsertNextPoint(p));
    }
  }
  thinned->SetPoints(points);
  return thinned;
}

vtkSmartPointer<vtkPolyData> AllThinnedPoints(
  vtkDataObject* data, const std::string& array, int most)
{
  const std::vector<vtkSmartPointer<vtkDataSet>> leaves = Leaves(data);
  vtkIdType total = 0;
  for (const auto& leaf : leaves)
  {
    total += leaf->GetNumberOfPoints();
  }
  const vtkIdType stride = std::max<vtkIdType>(1, (total + most - 1) / most);
  vtkNew<vtkAppendPolyData> append;
  for (const auto& leaf : leaves)
  {
    append->AddInputData(ThinnedPoints(WithPointArray(leaf, array), array, stride));
  }
  append->Update();
  vtkSmartPointer<vtkPolyData> points = append->GetOutput();
  if (points->GetNumberOfPoints() == 0)
  {
    Fail("the array '" + array +
      "' has no finite vector that is not zero, so there is nothing to draw; choose another");
  }
  return points;
}

// The length that a tenth of the vectors exceed.
double UsualLength(vtkPolyData* points, const std::string& array)
{
  vtkDataArray* const vectors = points->GetPointData()->GetArray(array.c_str());
  std::vector<double> lengths;
  for (vtkIdType i = 0; i < vectors->GetNumberOfTuples(); i++)
  {
    const double* const v = vectors->GetTuple3(i);
    lengths.push_back(std::hypot(v[0], v[1], v[2]));
  }
  const auto tenth = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() * 9 / 10);
  std::nth_element(lengths.begin(), tenth, lengths.end());
  return *tenth;
}

double Diagonal(vtkDataSet* data)
{
  return vtkBoundingBox(data->GetBounds()).GetDiagonalLength();
}

// Joined lines without what is nearer to the origin than the radius.
vtkSmartPointer<vtkPolyData> WithoutCentre(vtkPolyData* lines, double radius)
{
  vtkNew<vtkSphere> sphere;
  sphere->SetRadius(radius);
  vtkNew<vtkClipPolyData> clip;
  clip->SetInputData(lines);
  clip->SetClipFunction(sphere);
  vtkNew<vtkStripper> join; // the clip cuts polylines into segments
  join->SetInputConnection(clip->GetOutputPort());
  join->JoinContiguousSegmentsOn();
  join->SetMaximumLength(100000);
  join->Update();
  return join->GetOutput();
}
}

vtkSmartPointer<vtkPolyData> MakeArrows(
  vtkDataObject* data, const std::string& array, const ArrowSettings& settings)
{
  vtkSmartPointer<vtkPolyData> points = AllThinnedPoints(data, array, settings.Most);
  // the glyph filter leaves out what is marked as the scalars or the vectors
  points->GetPointData()->SetActiveScalars(nullptr);
  points->GetPointData()->SetActiveVectors(nullptr);
  const double spacing =
    Diagonal(points) / std::cbrt(static_cast<double>(points->GetNumberOfPoints()));
  const double length = settings.Length > 0 ? settings.Length : std::max(spacing, 1e-12);
  vtkNew<vtkArrowSource> arrow;
  arrow->SetTipRadius(settings.Thickness * arrow->GetTipRadius());
  arrow->SetShaftRadius(settings.Thickness * arrow->GetShaftRadius());
  arrow->SetTipResolution(settings.Resolution);
  arrow->SetShaftResolution(settings.Resolution);
  vtkNew<vtkGlyph3D> glyph;
  glyph->SetInputData(points);
  glyph->SetSourceConnection(arrow->GetOutputPort());
  glyph->SetInputArrayToProcess(1, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, array.c_str());
  glyph->SetVectorModeToUseVector();
  glyph->SetScaleModeToScaleByVector();
  glyph->SetScaleFactor(
    length / (settings.Reference > 0 ? settings.Reference : UsualLength(points, array)));
  glyph->Update();
  return glyph->GetOutput();
}

vtkSmartPointer<vtkPolyData> MakeStreamLines(
  vtkDataObject* data, const std::string& array, const TubeSettings& settings, bool forward)
{
  vtkSmartPointer<vtkPolyData> points = AllThinnedPoints(data, array, settings.Most);
  vtkNew<vtkStreamTracer> tracer;
  tracer->SetInputData(PointVectors(data, array));
  tracer->SetSourceData(settings.Seeds ? settings.Seeds : points);
  tracer->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, array.c_str());
  tracer->SetIntegratorTypeToRungeKutta4();
  tracer->SetIntegrationDirection(forward ? vtkStreamTracer::FORWARD : vtkStreamTracer::BOTH);
  tracer->SetIntegrationStepUnit(vtkStreamTracer::CELL_LENGTH_UNIT);
  tracer->SetInitialIntegrationStep(settings.Step);
  tracer->SetMaximumPropagation(settings.Length > 0 ? settings.Length : 2 * Diagonal(points));
  tracer->SetComputeVorticity(false);
  tracer->Update();
  return tracer->GetOutput();
}

vtkSmartPointer<vtkPolyData> MakeStreamTubes(
  vtkDataObject* data, const std::string& array, const TubeSettings& settings)
{
  vtkSmartPointer<vtkPolyData> lines = MakeStreamLines(data, array, settings, false);
  const double diagonal = Diagonal(AllThinnedPoints(data, array, settings.Most));
  if (settings.AvoidRadius > 0)
  {
    lines = WithoutCentre(lines, settings.AvoidRadius);
  }
  vtkNew<vtkTubeFilter> tube;
  tube->SetInputData(lines);
  tube->SetRadius(settings.Radius > 0 ? settings.Radius : std::max(diagonal / 1500, 1e-12));
  tube->SetNumberOfSides(settings.Sides);
  tube->CappingOn();
  tube->Update();
  if (tube->GetOutput()->GetNumberOfCells() == 0)
  {
    Fail("no stream line of '" + array + "' gets anywhere; choose another array");
  }
  return tube->GetOutput();
}
}
