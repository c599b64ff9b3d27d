// SPDX-License-Identifier: BSD-3-Clause
#include "Volume.h"

#include "Datasets.h"
#include "System/Progress.h"
#include "Text/Messages.h"

#include <vtkAbstractVolumeMapper.h>
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
#include <set>

namespace widefov
{
namespace
{
// Samples along the longest side of data that are no image.
constexpr int Samples = 128;

// Where the ramp of the values begins, a share of their range: what is low stays clear.
constexpr double RampStart = 0.15;

// A way across the whole diagonal takes so much light, on average: optical depth. The densest takes
// at most so much on a hundredth of it.
constexpr double DepthAcross = 4;
constexpr double WayShare = 0.01;
constexpr double DensestDepth = 1;

// Of the diagonal, the shortest and the longest way between samples. The spacing of coarse grids
// would show as rings, that of very flat ones takes for ever.
constexpr double LeastSampleShare = 0.00025;
constexpr double SampleShare = 0.0025;

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

// Once, of however many time steps.
void SayResampled(const std::string& label, const int dimensions[3])
{
  static std::set<std::string> said;
  if (said.insert(label).second)
  {
    Say(label + " is no image: its volume is resampled on a grid of " +
      std::to_string(dimensions[0]) + "x" + std::to_string(dimensions[1]) + "x" +
      std::to_string(dimensions[2]) + " points");
  }
}

// An image as it is, anything else sampled.
vtkSmartPointer<vtkImageData> OnGrid(
  vtkDataObject* data, const double size[3], const std::string& label)
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
  SayResampled(label, dimensions);
  vtkNew<vtkResampleToImage> resample;
  resample->SetInputDataObject(data);
  resample->SetSamplingDimensions(dimensions);
  resample->Update();
  return resample->GetOutput();
}

SceneVolume VolumeOf(const SceneProp& prop, const double size[3])
{
  const vtkSmartPointer<vtkImageData> grid =
    OnGrid(PointVectors(prop.Source, prop.Array), size, prop.Label);
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
  prop.Source = prop.Surface; // which is a thing to look at, as what it is round
  prop.Array.clear();
}
}

void ChooseVolumes(Scene& scene, const Look& look)
{
  const bool usual = look.UsualVolume && scene.FromFiles && look.Representation == "surface" &&
    look.Vectors.empty() && look.StreamLines.empty();
  bool any = false;
  for (SceneProp& prop : scene.Props)
  {
    if (look.Volume ? FillsSpace(prop.Source) : usual && IsSpatialImage(prop.Source))
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
      const bool taken = !prop.Array.empty() && !prop.Direct;
      prop.Kind = taken ? SceneProp::Shape::Outline : SceneProp::Shape::Mesh;
      if (taken)
      {
        TakeVolume(prop, scene);
      }
    }
  }
}

namespace
{
double RampAt(const SceneVolume& v, double value)
{
  const auto [low, high] = v.Range;
  const double start = low + RampStart * (high - low);
  return high > start ? std::clamp((value - start) / (high - start), 0., 1.) : 0;
}

// Of the densest, on a way of the unit: what is thin all over gets dense, what is full stays clear.
double Densest(const SceneVolume& v)
{
  vtkDataArray* const values = v.Data->GetPointData()->GetScalars();
  double sum = 0;
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); i++)
  {
    sum += RampAt(v, values->GetComponent(i, 0));
  }
  const double depth = WayShare * DepthAcross * static_cast<double>(values->GetNumberOfTuples());
  return 1 - std::exp(-std::min(DensestDepth, sum > 0 ? depth / sum : DensestDepth));
}

void SetLook(vtkVolumeProperty* property, const SceneVolume& v)
{
  const auto [low, high] = v.Range;
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(low, 0);
  opacity->AddPoint(low + RampStart * (high - low), 0);
  opacity->AddPoint(high, Densest(v));
  property->SetColor(vtkColorTransferFunction::SafeDownCast(v.ColorMap));
  property->SetScalarOpacity(opacity);
  property->SetInterpolationTypeToLinear();
}
}

void SetOpacity(vtkVolume* volume, double factor)
{
  const double size = volume->GetMapper()->GetDataSetInput()->GetLength();
  volume->GetProperty()->SetScalarOpacityUnitDistance(WayShare * size / factor);
}

std::vector<vtkSmartPointer<vtkVolume>> MakeVolumes(const Scene& scene, const Look& look)
{
  std::vector<vtkSmartPointer<vtkVolume>> volumes;
  for (const SceneVolume& v : scene.Volumes)
  {
    vtkNew<vtkGPUVolumeRayCastMapper> mapper;
    mapper->SetInputData(v.Data);
    mapper->AutoAdjustSampleDistancesOff();
    const double* const spacing = v.Data->GetSpacing();
    const double step = 0.5 * std::min({ spacing[0], spacing[1], spacing[2] });
    const double size = v.Data->GetLength();
    mapper->SetSampleDistance(
      static_cast<float>(std::clamp(step, LeastSampleShare * size, SampleShare * size)));
    auto volume = vtkSmartPointer<vtkVolume>::New();
    volume->SetMapper(mapper);
    SetLook(volume->GetProperty(), v);
    SetOpacity(volume, look.VolumeOpacity);
    volumes.push_back(volume);
  }
  return volumes;
}
}
