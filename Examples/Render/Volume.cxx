// SPDX-License-Identifier: BSD-3-Clause
#include "Volume.h"

#include "Datasets.h"
#include "Messages.h"
#include "Progress.h"

#include <vtkColorTransferFunction.h>
#include <vtkDataArray.h>
#include <vtkFloatArray.h>
#include <vtkGPUVolumeRayCastMapper.h>
#include <vtkNew.h>
#include <vtkOutlineSource.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPointData.h>
#include <vtkResampleToImage.h>
#include <vtkVolumeProperty.h>

#include <algorithm>
#include <cmath>

namespace widefov
{
namespace
{
// Samples along the longest side of data that are no image.
constexpr int Samples = 128;

// What of the light a way of a hundredth of the diagonal takes in the densest, and where the ramp
// of the values begins: what is low stays clear, else the eye in the middle sees nothing far.
constexpr double Densest = 0.1;
constexpr double WayShare = 0.01;
constexpr double RampStart = 0.15;

// The array with its point values finite and of one component: a component or the magnitude, as
// the map of colours takes it.
vtkSmartPointer<vtkFloatArray> Values(
  vtkDataArray* array, vtkDataArray* mask, vtkScalarsToColors* map, double lowest)
{
  auto values = vtkSmartPointer<vtkFloatArray>::New();
  values->SetName(array->GetName());
  values->SetNumberOfTuples(array->GetNumberOfTuples());
  const int components = array->GetNumberOfComponents();
  const bool one = components == 1 || map->GetVectorMode() == vtkScalarsToColors::COMPONENT;
  const int component = components == 1 ? 0 : map->GetVectorComponent();
  std::vector<double> tuple(static_cast<std::size_t>(components));
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); i++)
  {
    array->GetTuple(i, tuple.data());
    double sum = 0;
    for (const double x : tuple)
    {
      sum += x * x;
    }
    const double value = one ? tuple[static_cast<std::size_t>(component)] : std::sqrt(sum);
    const bool there = std::isfinite(value) && (mask == nullptr || mask->GetComponent(i, 0) > 0);
    values->SetValue(i, static_cast<float>(there ? value : lowest));
  }
  return values;
}

// An image as it is, anything else sampled.
vtkSmartPointer<vtkImageData> OnGrid(vtkDataObject* data, const double size[3])
{
  if (auto* const image = vtkImageData::SafeDownCast(data))
  {
    return image;
  }
  const Progress progress("sampling the data on a grid");
  const double spacing = std::max({ size[0], size[1], size[2] }) / (Samples - 1);
  int dimensions[3];
  for (int i = 0; i < 3; i++)
  {
    dimensions[i] = std::max(2, 1 + static_cast<int>(std::lround(size[i] / spacing)));
  }
  vtkNew<vtkResampleToImage> resample;
  resample->SetInputDataObject(data);
  resample->SetSamplingDimensions(dimensions);
  resample->Update();
  return resample->GetOutput();
}

SceneVolume VolumeOf(const SceneProp& prop, const double size[3])
{
  const vtkSmartPointer<vtkImageData> grid = OnGrid(PointVectors(prop.Source, prop.Array), size);
  vtkDataArray* const array = grid->GetPointData()->GetArray(prop.Array.c_str());
  if (array == nullptr)
  {
    Fail(prop.Label + ": the array '" + prop.Array +
      "' is not in all of its parts; --no-volume "
      "draws surfaces");
  }
  SceneVolume volume;
  volume.ColorMap = prop.ColorMap;
  const double* const range = prop.ColorMap->GetRange();
  volume.Range = { { range[0], range[1] } };
  volume.Data = vtkSmartPointer<vtkImageData>::New();
  volume.Data->CopyStructure(grid);
  volume.Data->GetPointData()->SetScalars(
    Values(array, grid->GetPointData()->GetArray("vtkValidPointMask"), prop.ColorMap, range[0]));
  return volume;
}

void TakeVolume(SceneProp& prop, Scene& scene)
{
  vtkBoundingBox box;
  for (const auto& leaf : Leaves(prop.Source))
  {
    box.AddBounds(leaf->GetBounds());
  }
  double b[6];
  box.GetBounds(b);
  const double size[3] = { b[1] - b[0], b[3] - b[2], b[5] - b[4] };
  scene.Volumes.push_back(VolumeOf(prop, size));
  vtkNew<vtkOutlineSource> outline;
  outline->SetBounds(b);
  outline->Update();
  prop.Surface = outline->GetOutput();
  prop.Array.clear();
  prop.InSpace = true;
}
}

void ChooseVolumes(Scene& scene, const Look& look)
{
  const bool usual = look.UsualVolume && scene.FromFiles && look.Representation == "surface" &&
    look.Vectors.empty() && look.StreamLines.empty();
  bool any = false;
  for (SceneProp& prop : scene.Props)
  {
    const bool image = vtkImageData::SafeDownCast(prop.Source) != nullptr;
    if (look.Volume ? FillsSpace(prop.Source) : usual && image && IsSpatialGrid(prop.Source))
    {
      prop.Kind = SceneProp::Shape::Volume;
      any = true;
    }
  }
  if (look.Volume && !any)
  {
    Fail("--volume: no data fill space; leave it out to see surfaces");
  }
}

void TakeVolumes(Scene& scene)
{
  for (SceneProp& prop : scene.Props)
  {
    if (prop.Kind == SceneProp::Shape::Volume)
    {
      prop.Kind = SceneProp::Shape::Mesh;
      if (!prop.Array.empty() && !prop.Direct)
      {
        TakeVolume(prop, scene);
      }
    }
  }
}

std::vector<vtkSmartPointer<vtkVolume>> MakeVolumes(const Scene& scene)
{
  std::vector<vtkSmartPointer<vtkVolume>> volumes;
  for (const SceneVolume& v : scene.Volumes)
  {
    vtkNew<vtkGPUVolumeRayCastMapper> mapper;
    mapper->SetInputData(v.Data);
    const auto [low, high] = v.Range;
    vtkNew<vtkPiecewiseFunction> opacity;
    opacity->AddPoint(low, 0);
    opacity->AddPoint(low + RampStart * (high - low), 0);
    opacity->AddPoint(high, Densest);
    auto volume = vtkSmartPointer<vtkVolume>::New();
    volume->SetMapper(mapper);
    vtkVolumeProperty* const property = volume->GetProperty();
    property->SetColor(vtkColorTransferFunction::SafeDownCast(v.ColorMap));
    property->SetScalarOpacity(opacity);
    property->SetScalarOpacityUnitDistance(WayShare * v.Data->GetLength());
    property->SetInterpolationTypeToLinear();
    volumes.push_back(volume);
  }
  return volumes;
}
}
