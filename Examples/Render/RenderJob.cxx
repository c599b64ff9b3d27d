// SPDX-License-Identifier: BSD-3-Clause
#include "RenderJob.h"

#include "CameraSetup.h"
#include "Frame.h"
#include "Messages.h"
#include "Passes.h"
#include "Progress.h"
#include "StereoLayout.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPanoramicProjectionPass.h>
#include <vtkPointData.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkScalarBarActor.h>
#include <vtkWideFoVCamera.h>
#include <vtkWideFoVDataPass.h>
#include <vtkWideFoVPass.h>
#include <vtkWideFoVRenderer.h>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace widefov
{
namespace
{
constexpr int WarmUpFrames = 2;

// Everything that lives as long as the window.
struct Stage
{
  vtkNew<vtkRenderWindow> Window;
  vtkSmartPointer<vtkRenderer> Renderer;
  vtkNew<vtkWideFoVPass> WidePass;
  std::vector<vtkSmartPointer<vtkActor>> Actors; // one a prop of the scene
  std::vector<int> StereoTypes;                  // one a traversal of a frame; none: mono
  vtkSmartPointer<vtkScalarBarActor> Bar;
};

void Fill(Stage& stage, const Scene& scene, const Options& o)
{
  if (o.Technique == Technique::CubeMap)
  {
    stage.Renderer = vtkSmartPointer<vtkRenderer>::New();
    stage.Renderer->SetPass(MakeCubeMapPass(o));
  }
  else
  {
    stage.Renderer = vtkSmartPointer<vtkWideFoVRenderer>::New();
    SetUpWidePass(stage.WidePass, o);
    stage.Renderer->SetPass(stage.WidePass);
  }
  stage.Renderer->SetBackground(o.Background.data());
  for (const SceneProp& prop : scene.Props)
  {
    stage.Actors.push_back(MakeActor(prop, o.Look));
    stage.Renderer->AddActor(stage.Actors.back());
  }
  stage.Bar = MakeScalarBar(scene);
  if (stage.Bar)
  {
    stage.Renderer->AddViewProp(stage.Bar);
  }
  SetCamera(stage.Renderer, scene, o);
  if (o.Stereo != "mono")
  {
    stage.StereoTypes = FindStereoLayout(o.Layout).Types;
  }
  stage.Window->AddRenderer(stage.Renderer);
  stage.Window->SetSize(o.Size[0], o.Size[1]);
}

// Draws with one of VTK's stereo types, or mono.
void Draw(Stage& stage, std::size_t i)
{
  if (i < stage.StereoTypes.size())
  {
    stage.Window->SetStereoType(stage.StereoTypes[i]);
    stage.Window->StereoRenderOn();
  }
  stage.Window->Render();
}

// Of all eyes.
double RenderFrame(Stage& stage)
{
  const auto start = std::chrono::steady_clock::now();
  for (std::size_t i = 0; i < std::max<std::size_t>(1, stage.StereoTypes.size()); i++)
  {
    Draw(stage, i);
  }
  stage.Window->WaitForCompletion();
  const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
  return time.count();
}

void RenderFrames(Stage& stage, const Options& o, RenderStats& stats)
{
  Progress progress("drawing");
  const bool timed = o.Frames > 0 || !o.Stats.empty();
  const int warmUps = timed ? WarmUpFrames : 0;
  const int total = warmUps + std::max(1, o.Frames);
  for (int i = 0; i < total; i++)
  {
    const double milliseconds = RenderFrame(stage);
    CheckMessages();
    progress.Update(double(i + 1) / total);
    if (i >= warmUps)
    {
      stats.Milliseconds.push_back(milliseconds);
    }
  }
}

// The last frame's, or, where it took several, drawn again.
std::vector<Picture> ReadPictures(Stage& stage, const Options& o)
{
  if (stage.StereoTypes.size() < 2)
  {
    return { ReadPicture(stage.Window) };
  }
  std::vector<Picture> eyes;
  for (std::size_t i = 0; i < stage.StereoTypes.size(); i++)
  {
    Draw(stage, i);
    CheckMessages();
    eyes.push_back(ReadPicture(stage.Window));
  }
  return Arrange(FindStereoLayout(o.Layout), eyes);
}

FloatPicture FlattenAov(vtkImageData* image)
{
  static const std::vector<std::pair<const char*, std::vector<std::string>>> arrays{
    { "color", { "R", "G", "B", "A" } }, { "distance", { "distance" } }, { "cell", { "cell" } },
    { "prop", { "prop" } }, { "normal", { "normal.X", "normal.Y", "normal.Z" } }
  };
  FloatPicture picture;
  picture.Width = image->GetDimensions()[0];
  picture.Height = image->GetDimensions()[1];
  for (const auto& [name, channels] : arrays)
  {
    picture.Channels.insert(picture.Channels.end(), channels.begin(), channels.end());
  }
  const std::size_t stride = picture.Channels.size();
  picture.Values.resize(stride * picture.Width * picture.Height);
  std::size_t channel = 0;
  for (const auto& [name, channels] : arrays)
  {
    vtkDataArray* const array = image->GetPointData()->GetArray(name);
    for (int c = 0; c < static_cast<int>(channels.size()); c++, channel++)
    {
      for (int j = 0; j < picture.Height; j++)
      {
        const vtkIdType from = static_cast<vtkIdType>(picture.Height - 1 - j) * picture.Width;
        float* to = &picture.Values[stride * j * picture.Width + channel];
        for (int i = 0; i < picture.Width; i++, to += stride)
        {
          *to = static_cast<float>(array->GetComponent(from + i, c));
        }
      }
    }
  }
  return picture;
}

// The channel "prop" from 1 + number of the actor to 1 + index of the file.
void NumberByFile(FloatPicture& picture, const Scene& scene)
{
  const std::size_t stride = picture.Channels.size();
  const auto channel = static_cast<std::size_t>(
    std::find(picture.Channels.begin(), picture.Channels.end(), "prop") - picture.Channels.begin());
  for (std::size_t i = channel; i < picture.Values.size(); i += stride)
  {
    const auto actor = static_cast<std::size_t>(picture.Values[i]);
    if (actor > 0)
    {
      picture.Values[i] = static_cast<float>(1 + scene.Props[actor - 1].Index);
    }
  }
}

FloatPicture RenderAov(Stage& stage, const Scene& scene)
{
  const Progress progress("drawing the float channels");
  vtkNew<vtkWideFoVDataPass> pass;
  pass->SetDelegatePass(stage.WidePass);
  for (std::size_t i = 0; i < stage.Actors.size(); i++)
  {
    // every actor has cells of its own; NumberByFile makes one of those of one file
    pass->SetPropIndex(stage.Actors[i], static_cast<int>(i));
  }
  if (stage.Bar)
  {
    stage.Bar->VisibilityOff(); // it is no surface
  }
  stage.Window->SetMultiSamples(0);
  stage.Renderer->SetPass(pass);
  stage.Window->Render();
  CheckMessages();
  FloatPicture picture = FlattenAov(pass->GetOutput());
  NumberByFile(picture, scene);
  stage.Renderer->SetPass(stage.WidePass);
  pass->ReleaseGraphicsResources(stage.Window);
  return picture;
}

void Count(Stage& stage, RenderStats& stats)
{
  stats.Gl = QueryStrings(stage.Window);
  stats.PropsTotal = static_cast<int>(stage.Actors.size());
  auto* const camera = vtkWideFoVCamera::SafeDownCast(stage.Renderer->GetActiveCamera());
  if (camera != nullptr && camera->IsWide()) // otherwise stock VTK draws, and does not count
  {
    const int others = stage.Bar ? 1 : 0; // it is no prop of the scene
    stats.PropsDrawn = stage.WidePass->GetNumberOfDrawnProps() - others;
    stats.PropsCulled = stage.WidePass->GetNumberOfCulledProps();
    stats.Clusters = stage.WidePass->GetNumberOfClusters();
    stats.ClustersCulled = stage.WidePass->GetNumberOfCulledClusters();
    stats.PlainDraws = stage.WidePass->GetNumberOfPlainDraws();
    stats.PreClipDraws = stage.WidePass->GetNumberOfPreClipDraws();
    stats.TessellateDraws = stage.WidePass->GetNumberOfTessellateDraws();
    stats.ExactDraws = stage.WidePass->GetNumberOfExactDraws();
  }
}
}

RenderResult Render(const Scene& scene, const Options& o)
{
  const DisplayConnection display;
  Stage stage;
  OpenWindow(stage.Window);
  const GlLimits limits = QueryLimits(stage.Window);
  CheckSize(o, limits);
  stage.Window->SetMultiSamples(UsableSamples(o.Samples, limits));
  RenderResult result;
  const QuietStandardError quiet;
  Fill(stage, scene, o);
  RenderFrames(stage, o, result.Stats);
  Count(stage, result.Stats);
  if (!o.Outputs.empty())
  {
    result.Colors = ReadPictures(stage, o);
  }
  if (!o.Aov.empty())
  {
    result.Aov = RenderAov(stage, scene);
  }
  CheckMessages();
  return result;
}
}
