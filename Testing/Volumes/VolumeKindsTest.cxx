// SPDX-License-Identifier: BSD-3-Clause
// Volumes in every projection, by each mapper that uses GPU ray casting, in tiles, between
// translucent surfaces; and those that cannot be drawn.
#include "VolumeCheck.h"

#include "Stereo/Stereo.h"

#include <vtkActor.h>
#include <vtkDataSetTriangleFilter.h>
#include <vtkFloatArray.h>
#include <vtkFixedPointVolumeRayCastMapper.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkMultiBlockVolumeMapper.h>
#include <vtkMultiVolume.h>
#include <vtkOutputWindow.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProjectedTetrahedraMapper.h>
#include <vtkProperty.h>
#include <vtkSmartVolumeMapper.h>
#include <vtkSphereSource.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWideFoVScreenCamera.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>

using namespace wfv;
using namespace wfv::test;
using reference::Blend;

namespace
{
// Of 255 levels, in the mean: a tile of a picture and the picture.
constexpr double TileLevels = 0.05;

// Counts what VTK warns of.
class Counter : public vtkOutputWindow
{
public:
  static Counter* New() { return new Counter; }
  void DisplayText(const char* text) override
  {
    this->Number += std::string(text).find("a volume is left out") != std::string::npos;
  }
  int Number = 0;
};

Shot Small(const char* projection, bool inside)
{
  Shot shot = ShotOf(projection, inside);
  shot.Width /= 2;
  shot.Height /= 2;
  return shot;
}

std::vector<unsigned char> PixelsOf(vtkRenderWindow* window)
{
  vtkNew<vtkUnsignedCharArray> pixels;
  const int* const size = window->GetActualSize(); // of a tile
  window->GetRGBACharPixelData(0, 0, size[0] - 1, size[1] - 1, 1, pixels);
  return { pixels->GetPointer(0), pixels->GetPointer(0) + pixels->GetNumberOfValues() };
}

std::vector<unsigned char> PictureOf(VolumeScene& scene, const Shot& shot)
{
  scene.Draw(shot);
  return PixelsOf(scene.Window);
}

double MeanDifference(const std::vector<unsigned char>& a, const std::vector<unsigned char>& b)
{
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); i++)
  {
    sum += std::abs(int(a[i]) - int(b[i]));
  }
  return a.size() == b.size() ? sum / double(a.size()) : 255;
}
}

TEST(VolumeKinds, EveryProjection)
{
  VolumeScene scene(Wavelet());
  scene.SetBall({ vec3(2, -1, 3), 2.5 });
  for (const Projection& projection : Projections())
  {
    for (bool inside : { false, true })
    {
      Check(scene, Small(projection.Name.c_str(), inside), inside ? "any-inside" : "any-outside");
    }
  }
}

// By stock VTK, along the rays of each eye. A surface there would have VTK's own depth.
TEST(VolumeKinds, BothEyesOfAPerspective)
{
  VolumeScene scene(Wavelet());
  Shot shot = Small("perspective", false);
  shot.Options.Radii = { { 1, 100 } };
  shot.Options.HorizontalFov = 80;
  shot.Options.VerticalFov = 50;
  shot.Options.Stereo.Model = FindStereoModel("offaxis");
  for (const Eye eye : { Eye::Left, Eye::Right })
  {
    shot.Options.Stereo.Eye = eye;
    Check(scene, shot, eye == Eye::Left ? "offaxis-left" : "offaxis-right");
  }
}

// A screen at the side of a room, and an eye that is not before its middle.
TEST(VolumeKinds, AScreenOfARoom)
{
  VolumeScene scene(Wavelet());
  vtkNew<vtkWideFoVScreenCamera> camera;
  const double corners[3][3] = { { -1.2, -0.8, -1 }, { 0.9, -0.8, -1.6 }, { 0.9, 0.7, -1.6 } };
  camera->SetScreen(corners[0], corners[1], corners[2]);
  camera->SetHeadPosition(0.5, -0.3, 0.2);
  camera->SetPosition(3, -2, 17);
  camera->SetFocalPoint(3, -2, 16);
  camera->SetClipRadii(0.5, 100);
  const auto place = [](const double* p) { return vec3(3 + p[0], p[1] - 2, 17 + p[2]); };
  const VolumeError e = scene.CompareScreen(
    camera, vec3(3.5, -2.3, 17.2), { place(corners[0]), place(corners[1]), place(corners[2]) });
  std::cout << "screen: mean " << 255 * e.Mean << "/255 seen " << e.Seen << std::endl;
  EXPECT_LT(e.Mean, 1.0 / 255);
  EXPECT_GT(e.Seen, 0.3);
}

TEST(VolumeKinds, SmartAndMultiBlockMappersDrawTheSame)
{
  VolumeScene scene(Wavelet());
  const Shot shot = Small("equirectangular", true);
  scene.Mapper->SetLockSampleDistanceToInputSpacing(1); // as the smart mapper does
  const std::vector<unsigned char> wanted = PictureOf(scene, shot);
  vtkNew<vtkSmartVolumeMapper> smart;
  smart->SetInputData(scene.Mapper->GetInput());
  smart->SetAutoAdjustSampleDistances(0);
  smart->SetSampleDistance(scene.Mapper->GetSampleDistance());
  scene.Volume->SetMapper(smart);
  EXPECT_EQ(PictureOf(scene, shot), wanted);
  EXPECT_EQ(smart->GetLastUsedRenderMode(), vtkSmartVolumeMapper::GPURenderMode);
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, scene.Mapper->GetInput());
  vtkNew<vtkMultiBlockVolumeMapper> several;
  several->SetInputDataObject(blocks);
  scene.Volume->SetMapper(several);
  // it has a sample distance of its own
  EXPECT_LT(MeanDifference(PictureOf(scene, shot), wanted), 3);
}

namespace
{
// Of 255 levels, in the mean: by the pass, and by stock VTK, whose entry is interpolated along
// faces.
constexpr double StockLevels = 1;

// The perspective, which both draw, of whatever the scene has.
void CompareWithStock(VolumeScene& scene, const std::string& name)
{
  Shot shot = ShotOf("perspective", false);
  shot.Options.HorizontalFov = 80;
  shot.Options.VerticalFov = 50;
  shot.Width = 128;
  shot.Height = 72;
  scene.Stock = true;
  scene.Draw(shot, PictureName(name + "-stock"));
  const std::vector<unsigned char> wanted = PixelsOf(scene.Window);
  EXPECT_EQ(scene.Pass->GetNumberOfProjectedDraws(), 0) << name;
  scene.Stock = false;
  scene.Draw(shot, PictureName(name));
  const double off = MeanDifference(PixelsOf(scene.Window), wanted);
  std::cout << name << ": mean " << off << " levels from stock VTK's perspective" << std::endl;
  EXPECT_EQ(scene.Pass->GetNumberOfProjectedDraws(), 1) << name;
  EXPECT_LT(off, StockLevels) << name;
  EXPECT_GT(*std::max_element(wanted.begin(), wanted.end()), 60) << name;
}

// The wavelet, and how far it is from its middle value, with gradients for two functions.
vtkSmartPointer<vtkImageData> TwoComponents()
{
  const vtkSmartPointer<vtkImageData> image = Wavelet();
  vtkDataArray* const values = image->GetPointData()->GetScalars();
  vtkNew<vtkFloatArray> both;
  both->SetName("both");
  both->SetNumberOfComponents(2);
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); i++)
  {
    const double value = values->GetComponent(i, 0);
    both->InsertNextTuple2(value, std::abs(value - 157));
  }
  image->GetPointData()->SetScalars(both);
  return image;
}

vtkSmartPointer<vtkImageData> HalfMask(vtkImageData* image)
{
  auto mask = vtkSmartPointer<vtkImageData>::New();
  mask->CopyStructure(image);
  mask->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  int size[3];
  image->GetDimensions(size);
  auto* values = static_cast<unsigned char*>(mask->GetScalarPointer());
  for (int i = 0; i < size[0] * size[1] * size[2]; i++)
  {
    values[i] = i % size[0] < size[0] / 2 ? 255 : 0;
  }
  return mask;
}
}

TEST(VolumeKinds, SeveralVolumesInOne)
{
  VolumeScene scene(Wavelet());
  vtkNew<vtkVolume> other;
  other->SetProperty(scene.Volume->GetProperty());
  other->SetPosition(16, 3, -4);
  scene.Renderer->RemoveAllViewProps();
  vtkNew<vtkMultiVolume> both;
  vtkNew<vtkGPUVolumeRayCastMapper> mapper;
  mapper->SetAutoAdjustSampleDistances(0);
  mapper->SetSampleDistance(scene.Mapper->GetSampleDistance());
  both->SetMapper(mapper);
  for (int i = 0; i < 2; i++)
  {
    mapper->SetInputDataObject(i, scene.Mapper->GetInput());
    both->SetVolume(i == 0 ? scene.Volume.Get() : other.Get(), i);
  }
  scene.Renderer->AddVolume(both);
  CompareWithStock(scene, "multi-volume");
}

TEST(VolumeKinds, SeveralComponentsAndMasksAsStock)
{
  {
    VolumeScene scene(TwoComponents());
    vtkVolumeProperty* const look = scene.Volume->GetProperty();
    look->IndependentComponentsOn();
    look->SetScalarOpacity(1, look->GetScalarOpacity(0));
    look->SetColor(1, look->GetRGBTransferFunction(0));
    CompareWithStock(scene, "components");
  }
  const vtkSmartPointer<vtkImageData> image = Wavelet();
  VolumeScene scene(image);
  scene.Mapper->SetMaskInput(HalfMask(image));
  scene.Mapper->SetMaskTypeToBinary();
  CompareWithStock(scene, "mask");
}

TEST(VolumeKinds, TwoDimensionalFunctionsAsStock)
{
  VolumeScene scene(Wavelet());
  vtkNew<vtkImageData> function;
  function->SetDimensions(64, 64, 1);
  function->AllocateScalars(VTK_FLOAT, 4);
  for (int j = 0; j < 64; j++)
  {
    for (int i = 0; i < 64; i++)
    {
      auto* const rgba = static_cast<float*>(function->GetScalarPointer(i, j, 0));
      rgba[0] = i / 63.0f;
      rgba[1] = j / 63.0f;
      rgba[2] = 0.3f;
      rgba[3] = 0.1f * i / 63.0f;
    }
  }
  scene.Volume->GetProperty()->SetTransferFunction2D(function);
  CompareWithStock(scene, "two-dimensional");
}

TEST(VolumeKinds, TilesAreThePicture)
{
  VolumeScene scene(Wavelet());
  scene.SetBall({ vec3(2, -1, 3), 2.5 });
  const Shot whole = ShotOf("equirectangular", true);
  const std::vector<unsigned char> wanted = PictureOf(scene, whole);
  scene.Window->SetTileScale(2, 2);
  Shot tile = whole;
  tile.Width /= 2;
  tile.Height /= 2;
  for (int t = 0; t < 4; t++)
  {
    const double x = 0.5 * (t & 1);
    const double y = 0.5 * (t >> 1);
    scene.Window->SetTileViewport(x, y, x + 0.5, y + 0.5);
    const std::vector<unsigned char> drawn = PictureOf(scene, tile);
    std::vector<unsigned char> part;
    for (int j = 0; j < tile.Height; j++)
    {
      const auto row = wanted.begin() +
        4 * ((std::size_t(j) + (t >> 1) * tile.Height) * whole.Width + (t & 1) * tile.Width);
      part.insert(part.end(), row, row + std::ptrdiff_t(4) * tile.Width);
    }
    // the surfaces' depths are read between texels, rounded
    EXPECT_LT(MeanDifference(drawn, part), TileLevels) << t;
  }
}

TEST(VolumeKinds, JitteringAndCoarserImagesAreNearThePicture)
{
  VolumeScene scene(Wavelet());
  scene.SetBall({ vec3(2, -1, 3), 2.5 });
  const Shot shot = Small("hammer", true);
  const std::vector<unsigned char> wanted = PictureOf(scene, shot);
  scene.Mapper->UseJitteringOn();
  const double jittered = MeanDifference(PictureOf(scene, shot), wanted);
  EXPECT_GT(jittered, 0);
  EXPECT_LT(jittered, 4);
  scene.Mapper->UseJitteringOff();
  scene.Mapper->SetImageSampleDistance(2);
  const double coarse = MeanDifference(PictureOf(scene, shot), wanted);
  EXPECT_GT(coarse, 0);
  EXPECT_LT(coarse, 4);
}

// In the order of their depths: the volume before a translucent ball, inside and behind it.
TEST(VolumeKinds, TranslucentSurfacesInside)
{
  VolumeScene scene(Wavelet());
  scene.Renderer->UseDepthPeelingOn();
  scene.Renderer->UseDepthPeelingForVolumesOn();
  scene.Window->SetAlphaBitPlanes(1);
  vtkNew<vtkSphereSource> ball;
  ball->SetRadius(2.5);
  ball->SetCenter(2, -1, 3);
  ball->SetThetaResolution(200);
  ball->SetPhiResolution(200);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(ball->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  actor->GetProperty()->SetColor(0.2, 0.9, 0.3);
  actor->GetProperty()->SetOpacity(0.4);
  scene.Renderer->AddActor(actor);
  scene.SetTranslucent({ vec3(2, -1, 3), 2.5 }, 0.4);
  for (bool inside : { false, true })
  {
    Check(scene, ShotOf("equirectangular", inside), inside ? "glass-inside" : "glass-outside");
  }
}

namespace
{
// Draws twice; what was said meanwhile is counted.
int CountWords(VolumeScene& scene, const Shot& shot, std::vector<unsigned char>& picture)
{
  vtkNew<Counter> counter;
  const vtkSmartPointer<vtkOutputWindow> before = vtkOutputWindow::GetInstance();
  vtkOutputWindow::SetInstance(counter);
  picture = PictureOf(scene, shot);
  EXPECT_EQ(PictureOf(scene, shot), picture);
  vtkOutputWindow::SetInstance(before);
  return counter->Number;
}
}

TEST(VolumeKinds, ThoseOfTheProcessorAreDrawnOnTheGpu)
{
  vtkNew<vtkFixedPointVolumeRayCastMapper> fixed;
  vtkNew<vtkSmartVolumeMapper> smart;
  smart->SetRequestedRenderModeToRayCast();
  const Shot shot = Small("equirectangular", true);
  for (int mode : { vtkVolumeMapper::COMPOSITE_BLEND, vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND })
  {
    VolumeScene scene(Wavelet());
    vtkNew<vtkGPUVolumeRayCastMapper> rays; // as VTK makes it: it finds the distance of samples
    rays->SetInputData(scene.Mapper->GetInput());
    rays->SetBlendMode(mode);
    scene.Volume->SetMapper(rays);
    const std::vector<unsigned char> wanted = PictureOf(scene, shot);
    for (vtkVolumeMapper* mapper : std::initializer_list<vtkVolumeMapper*>{ fixed, smart })
    {
      mapper->SetInputData(scene.Mapper->GetInput());
      mapper->SetBlendMode(mode);
      scene.Volume->SetMapper(mapper);
      std::vector<unsigned char> drawn;
      EXPECT_EQ(CountWords(scene, shot, drawn), 0);
      EXPECT_LT(MeanDifference(drawn, wanted), 0.5) << mapper->GetClassName();
      EXPECT_EQ(scene.Volume->GetMapper(), mapper);
      mapper->SetBlendModeToMinimumIntensity(); // which is seen at once
      EXPECT_GT(MeanDifference(PictureOf(scene, shot), wanted), 3);
    }
  }
}

TEST(VolumeKinds, ThoseOfTetrahedraAreLeftOutWithOneWarning)
{
  VolumeScene scene(Wavelet());
  const Shot shot = Small("equirectangular", true);
  vtkNew<vtkDataSetTriangleFilter> tetrahedra;
  tetrahedra->SetInputData(scene.Mapper->GetInput());
  vtkNew<vtkProjectedTetrahedraMapper> mapper;
  mapper->SetInputConnection(tetrahedra->GetOutputPort());
  scene.Renderer->RemoveVolume(scene.Volume);
  const std::vector<unsigned char> nothing = PictureOf(scene, shot);
  scene.Volume->SetMapper(mapper);
  scene.Renderer->AddVolume(scene.Volume);
  std::vector<unsigned char> drawn;
  EXPECT_EQ(CountWords(scene, shot, drawn), 1);
  EXPECT_EQ(drawn, nothing);
}

TEST(VolumeKinds, OneLayerOfPointsIsLeftOutWithOneWarning)
{
  VolumeScene scene(Wavelet());
  const Shot shot = Small("equirectangular", true);
  scene.Renderer->RemoveVolume(scene.Volume);
  const std::vector<unsigned char> nothing = PictureOf(scene, shot);
  vtkNew<vtkImageData> layer;
  layer->SetDimensions(8, 8, 1);
  layer->AllocateScalars(VTK_FLOAT, 1);
  layer->GetPointData()->GetScalars()->Fill(100);
  scene.Mapper->SetInputData(layer);
  scene.Renderer->AddVolume(scene.Volume);
  std::vector<unsigned char> drawn;
  EXPECT_EQ(CountWords(scene, shot, drawn), 1);
  EXPECT_EQ(drawn, nothing);
}
