// SPDX-License-Identifier: BSD-3-Clause
#include "SightsJob.h"

#include "CameraSetup.h"
#include "Frame.h"
#include "Messages.h"
#include "Passes.h"
#include "PictureFiles.h"
#include "Progress.h"
#include "RenderStats.h"
#include "ShownScene.h"
#include "SkyPicture.h"
#include "StereoChoice.h"
#include "StereoLayout.h"
#include "StereoOptions.h"

#include <vtkNew.h>
#include <vtkPanoramicProjectionPass.h>
#include <vtkRenderWindow.h>
#include <vtkScalarBarActor.h>
#include <vtkWideFoVPass.h>
#include <vtkWideFoVRenderer.h>

#include <algorithm>
#include <chrono>

namespace widefov
{
namespace
{
// What all pictures share: the window, the actors with their buffers.
class SightsStage
{
public:
  SightsStage(const Scene& scene, const Options& o);

  // Draws one picture: of one eye, or both in one picture.
  void Draw(const Options& sight, std::size_t type);

  // The pictures of the sight's layout.
  std::vector<Picture> Take(const Options& sight);

  void WaitForCompletion() { this->Window->WaitForCompletion(); }
  GlStrings GetStrings() { return QueryStrings(this->Window); }

private:
  const Scene& What;
  GlLimits Limits;
  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkWideFoVRenderer> Renderer;
  vtkNew<vtkWideFoVPass> Pass;
};

// VTK's stereo types to draw with, one after the other; one for mono.
std::size_t CountTypes(const Options& o)
{
  return !HasTwoEyes(o) ? 1 : FindStereoLayout(o.Layout).Types.size();
}

SightsStage::SightsStage(const Scene& scene, const Options& o)
  : What(scene)
{
  OpenWindow(this->Window);
  this->Limits = QueryLimits(this->Window);
  this->Window->SetMultiSamples(UsableSamples(o.Samples, this->Limits));
  SetUpWidePass(this->Pass, o);
  this->Renderer->SetPass(this->Pass);
  SetBackground(this->Renderer, o);
  ShowScene(this->Renderer, scene, o.Look);
  if (const vtkSmartPointer<vtkScalarBarActor> bar = MakeScalarBar(scene))
  {
    this->Renderer->AddViewProp(bar);
  }
  this->Window->AddRenderer(this->Renderer);
}

void SightsStage::Draw(const Options& sight, std::size_t type)
{
  CheckSize(sight, this->Limits);
  this->Window->SetSize(sight.Size[0], sight.Size[1]);
  SetCamera(this->Renderer, this->What, sight);
  if (HasTwoEyes(sight))
  {
    this->Window->SetStereoType(FindStereoLayout(sight.Layout).Types[type]);
    SetAnaglyph(this->Window, sight);
    this->Window->StereoRenderOn();
  }
  this->Window->Render();
  CheckMessages();
}

std::vector<Picture> SightsStage::Take(const Options& sight)
{
  std::vector<Picture> pictures;
  for (std::size_t i = 0; i < CountTypes(sight); i++)
  {
    this->Draw(sight, i);
    pictures.push_back(ReadPicture(this->Window));
  }
  return pictures;
}

void Time(SightsStage& stage, const std::vector<Options>& sights, int frames, RenderStats& stats)
{
  for (int i = 0; i < WarmUpFrames + std::max(1, frames); i++)
  {
    const auto start = std::chrono::steady_clock::now();
    for (const Options& sight : sights)
    {
      for (std::size_t type = 0; type < CountTypes(sight); type++)
      {
        stage.Draw(sight, type);
      }
    }
    stage.WaitForCompletion();
    const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
    if (i >= WarmUpFrames)
    {
      stats.Milliseconds.push_back(time.count());
    }
  }
}

void Write(const Options& sight, const std::vector<Picture>& pictures, OutputFiles& files)
{
  for (const std::string& output : sight.Outputs)
  {
    for (const auto& [name, bytes] : EncodeFiles(sight, output, pictures))
    {
      CheckWritable(name);
      files.Write(name, bytes.data(), bytes.size());
    }
  }
}
}

RenderStats RenderSights(const Scene& scene, const Options& o, OutputFiles& files)
{
  Sights all(o);
  std::vector<Options> sights = all.Next();
  const DisplayConnection display;
  SightsStage stage(scene, o);
  const QuietStandardError quiet;
  const Progress progress("drawing");
  RenderStats stats;
  stats.Gl = stage.GetStrings();
  stats.PropsTotal = static_cast<int>(scene.Props.size());
  if (o.Frames > 0 || !o.Stats.empty())
  {
    Time(stage, sights, o.Frames, stats);
  }
  for (; !sights.empty() && !o.Outputs.empty(); sights = all.Next())
  {
    for (const Options& sight : sights)
    {
      Write(sight, stage.Take(sight), files);
    }
  }
  return stats;
}
}
