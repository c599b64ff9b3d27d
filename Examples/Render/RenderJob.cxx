// SPDX-License-Identifier: BSD-3-Clause
#include "RenderJob.h"

#include "CameraSetup.h"
#include "MessageCatcher.h"
#include "Messages.h"
#include "Passes.h"
#include "Progress.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPanoramicProjectionPass.h>
#include <vtkPointData.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkScalarBarActor.h>
#include <vtkTextProperty.h>
#include <vtkUnsignedCharArray.h>
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
  vtkSmartPointer<vtkScalarBarActor> Bar;
};

// An error of VTK ends the job; a warning is passed on.
void CheckMessages()
{
  const std::string error = MessageCatcher::TakeFirstError();
  if (!error.empty())
  {
    Fail("drawing failed: " + error + "; update the graphics driver, or report it");
  }
  for (const std::string& warning : MessageCatcher::TakeWarnings())
  {
    Say("warning: " + warning);
  }
}

void CheckSize(const Options& o, const GlLimits& limits)
{
  if (o.Size[0] > limits.Width || o.Size[1] > limits.Height)
  {
    Fail("--size " + std::to_string(o.Size[0]) + "x" + std::to_string(o.Size[1]) +
      " is over the limit of this OpenGL, " + std::to_string(limits.Width) + "x" +
      std::to_string(limits.Height) + " pixels; choose a smaller size");
  }
  if (o.Technique == Technique::CubeMap && o.CubeMapResolution > limits.Width)
  {
    Fail("--cubemap-resolution " + std::to_string(o.CubeMapResolution) +
      " is over the limit of this OpenGL, " + std::to_string(limits.Width) +
      " pixels; choose a smaller one");
  }
}

void SetSamples(Stage& stage, const Options& o, const GlLimits& limits)
{
  int samples = o.Samples;
  if (samples > limits.Samples)
  {
    Say("warning: --samples " + std::to_string(samples) + " is over the limit of this OpenGL; " +
      std::to_string(limits.Samples) + " are used");
    samples = limits.Samples;
  }
  stage.Window->SetMultiSamples(samples > 1 ? samples : 0);
}

void AddBar(Stage& stage, const Scene& scene)
{
  if (!scene.BarMap)
  {
    return;
  }
  stage.Bar = vtkSmartPointer<vtkScalarBarActor>::New();
  stage.Bar->SetLookupTable(scene.BarMap);
  stage.Bar->SetTitle(scene.BarTitle.c_str());
  stage.Bar->SetNumberOfLabels(5);
  stage.Bar->SetOrientationToHorizontal();
  stage.Bar->SetPosition(0.36, 0.03);
  stage.Bar->SetWidth(0.28);
  stage.Bar->SetHeight(0.10);
  stage.Bar->SetLabelFormat("%.3g");
  for (vtkTextProperty* const text :
    { stage.Bar->GetTitleTextProperty(), stage.Bar->GetLabelTextProperty() })
  {
    text->ItalicOff();
    text->ShadowOn();
  }
  stage.Renderer->AddViewProp(stage.Bar);
}

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
  AddBar(stage, scene);
  SetCamera(stage.Renderer, scene, o);
  stage.Window->AddRenderer(stage.Renderer);
  stage.Window->SetSize(o.Size[0], o.Size[1]);
}

double RenderFrame(Stage& stage)
{
  const auto start = std::chrono::steady_clock::now();
  stage.Window->Render();
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

Picture ReadPicture(Stage& stage)
{
  Picture picture;
  const int* const size = stage.Window->GetSize();
  picture.Width = size[0];
  picture.Height = size[1];
  vtkNew<vtkUnsignedCharArray> pixels;
  stage.Window->GetPixelData(0, 0, size[0] - 1, size[1] - 1, 0, pixels);
  const std::size_t row = 3 * static_cast<std::size_t>(picture.Width);
  picture.Rgb.resize(row * picture.Height);
  for (int j = 0; j < picture.Height; j++)
  {
    const unsigned char* const from =
      pixels->GetPointer(static_cast<vtkIdType>(row) * (picture.Height - 1 - j));
    std::copy(from, from + row, picture.Rgb.begin() + static_cast<std::ptrdiff_t>(row * j));
  }
  return picture;
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
  SetSamples(stage, o, limits);
  RenderResult result;
  const QuietStandardError quiet;
  Fill(stage, scene, o);
  RenderFrames(stage, o, result.Stats);
  Count(stage, result.Stats);
  if (!o.Outputs.empty())
  {
    result.Color = ReadPicture(stage);
  }
  if (!o.Aov.empty())
  {
    result.Aov = RenderAov(stage, scene);
  }
  CheckMessages();
  return result;
}
}
