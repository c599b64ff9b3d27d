// SPDX-License-Identifier: BSD-3-Clause
#include "BenchStage.h"

#include "Pictures/CameraSetup.h"
#include "CellPictures.h"
#include "InteractiveRate.h"
#include "System/Display.h"
#include "Scenes/MeshBuilder.h"
#include "Scenes/SceneActor.h"
#include "System/MessageCatcher.h"
#include "Text/Messages.h"
#include "Pictures/Passes.h"
#include "Options/StereoChoice.h"

#include <vtkBoundingBox.h>
#include <vtkCamera.h>
#include <vtkNew.h>
#include <vtkPanoramicProjectionPass.h>
#include <vtkWideFoVRenderer.h>
#include <Gl.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>

namespace wfv
{
namespace bench
{
namespace
{
// Halvings of the range of scales that the floor's camera is looked for in.
constexpr int FloorSteps = 12;

// The range, in diagonals of the scene: half the height of the picture.
constexpr double LeastScale = 1e-3;
constexpr double MostScale = 2;

void CheckMessages(const Run& run)
{
  const std::string error = widefov::MessageCatcher::TakeFirstError();
  if (!error.empty())
  {
    widefov::Fail("drawing " + NameOf(run) + " failed: " + error);
  }
}

double SceneDiagonal(const widefov::Scene& scene)
{
  double b[6];
  widefov::SceneBounds(scene, b);
  return vtkBoundingBox(b).GetDiagonalLength();
}

// A parallel camera outside the scene that looks at its middle, in the direction of the run.
void SetFloorCamera(vtkRenderer* renderer, const widefov::Scene& scene, const widefov::Options& o)
{
  const widefov::Pose pose = widefov::MakePose(scene, o);
  double b[6];
  widefov::SceneBounds(scene, b);
  const widefov::Vector3 middle{ { 0.5 * (b[0] + b[1]), 0.5 * (b[2] + b[3]),
    0.5 * (b[4] + b[5]) } };
  using widefov::operator-;
  using widefov::operator*;
  const widefov::Vector3 eye = middle - SceneDiagonal(scene) * pose.Direction;
  vtkNew<vtkCamera> camera;
  camera->ParallelProjectionOn();
  camera->SetPosition(eye.data());
  camera->SetFocalPoint(middle.data());
  camera->SetViewUp(pose.Up.data());
  camera->SetParallelScale(SceneDiagonal(scene));
  renderer->SetActiveCamera(camera);
  renderer->ResetCameraClippingRange();
}

void SetUp(BenchEntry& entry, const widefov::Scene& scene)
{
  const widefov::Options& o = entry.Run.Options;
  const bool cubemap = o.Technique == widefov::Technique::CubeMap;
  if (cubemap || entry.Run.Method == "floor")
  {
    entry.Renderer = vtkSmartPointer<vtkRenderer>::New();
  }
  else
  {
    entry.Renderer = vtkSmartPointer<vtkWideFoVRenderer>::New();
    entry.WidePass = vtkSmartPointer<vtkWideFoVPass>::New();
    widefov::SetUpWidePass(entry.WidePass, o);
    entry.Renderer->SetPass(entry.WidePass);
  }
  for (const widefov::SceneProp& prop : scene.Props)
  {
    entry.Actors.push_back(widefov::MakeActor(prop, o.Look));
    entry.Renderer->AddActor(entry.Actors.back());
  }
  if (entry.Run.Method == "floor")
  {
    SetFloorCamera(entry.Renderer, scene, o);
    return;
  }
  widefov::SetCamera(entry.Renderer, scene, o);
  entry.Start = widefov::MakePose(scene, o);
  if (cubemap)
  {
    widefov::SetCubeMapPass(entry.Renderer, widefov::MakeCubeMapPass(o));
  }
}
}

BenchStage::BenchStage(const BenchScene& scene, const std::vector<Run>& runs)
  : Scene(scene)
{
  this->Entries.reserve(runs.size());
  for (const Run& run : runs)
  {
    this->Add(run);
  }
}

BenchStage::~BenchStage() = default;

vtkRenderWindow* BenchStage::WindowOf(const widefov::Options& o)
{
  vtkSmartPointer<vtkRenderWindow>& window = this->Windows[{ { o.Size[0], o.Size[1], o.Samples } }];
  if (!window)
  {
    window = vtkSmartPointer<vtkRenderWindow>::New();
    widefov::OpenWindow(window);
    const widefov::GlLimits limits = widefov::QueryLimits(window);
    if (o.Size[0] > limits.Width || o.Size[1] > limits.Height || o.Samples > limits.Samples)
    {
      widefov::Fail("--size is over the limit of this OpenGL, " + std::to_string(limits.Width) +
        "x" + std::to_string(limits.Height) + " pixels with " + std::to_string(limits.Samples) +
        " samples; choose a smaller size");
    }
    window->SetMultiSamples(o.Samples);
    window->SetSize(o.Size[0], o.Size[1]);
  }
  return window;
}

void BenchStage::Add(const Run& run)
{
  BenchEntry entry;
  entry.Run = run;
  entry.Window = this->WindowOf(run.Options);
  if (run.Motion.Mode == Mode::Turn)
  {
    entry.Window->SetDesiredUpdateRate(InteractiveRate);
  }
  SetUp(entry, this->Scene.Scene);
  entry.Renderer->DrawOff();
  entry.Window->AddRenderer(entry.Renderer);
  this->Entries.push_back(entry);
}

namespace
{
void DrawEyes(BenchEntry& entry)
{
  if (!HasTwoEyes(entry.Run.Options))
  {
    entry.Window->Render();
    return;
  }
  entry.Window->StereoRenderOn();
  for (const int eye : { VTK_STEREO_LEFT, VTK_STEREO_RIGHT })
  {
    entry.Window->SetStereoType(eye);
    entry.Window->Render();
  }
  entry.Window->StereoRenderOff();
}
}

void BenchStage::Move(BenchEntry& entry) const
{
  if (entry.Run.Motion.Mode == Mode::Still)
  {
    return;
  }
  const double radius = CircleShare * SceneDiagonal(this->Scene.Scene);
  const widefov::Pose pose = PoseAt(entry.Start, radius, entry.Run.Motion, ++entry.Moves);
  vtkCamera* const camera = entry.Renderer->GetActiveCamera();
  using widefov::operator+;
  using widefov::operator*;
  const widefov::Vector3 ahead = pose.Eye + camera->GetDistance() * pose.Direction;
  camera->SetPosition(pose.Eye.data());
  camera->SetFocalPoint(ahead.data());
  camera->SetViewUp(pose.Up.data());
  camera->OrthogonalizeViewUp();
}

FrameTime BenchStage::Draw(BenchEntry& entry)
{
  this->Move(entry);
  entry.Renderer->DrawOn();
  entry.Window->MakeCurrent();
  const std::clock_t used = std::clock();
  const auto start = std::chrono::steady_clock::now();
  DrawEyes(entry);
  entry.Window->WaitForCompletion();
  const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
  const double processor = 1000.0 * static_cast<double>(std::clock() - used) / CLOCKS_PER_SEC;
  entry.Renderer->DrawOff();
  CheckMessages(entry.Run);
  return { time.count(), processor };
}

std::optional<long long> BenchStage::CountFragments(BenchEntry& entry)
{
  entry.Window->MakeCurrent();
  if (!WIDEFOV_HAS_GL(ARB_pipeline_statistics_query))
  {
    return std::nullopt;
  }
  GLuint query = 0;
  GLuint64 runs = 0;
  glGenQueries(1, &query);
  glBeginQuery(GL_FRAGMENT_SHADER_INVOCATIONS_ARB, query);
  this->Draw(entry);
  glEndQuery(GL_FRAGMENT_SHADER_INVOCATIONS_ARB);
  glGetQueryObjectui64v(query, GL_QUERY_RESULT, &runs);
  glDeleteQueries(1, &query);
  return static_cast<long long>(runs);
}

long BenchStage::FitFloor(BenchEntry& entry, long pixels)
{
  const double diagonal = SceneDiagonal(this->Scene.Scene);
  vtkCamera* const camera = entry.Renderer->GetActiveCamera();
  double low = std::log(LeastScale * diagonal);
  double high = std::log(MostScale * diagonal);
  double best = low;
  long covered = -1;
  DataPicture picture(entry);
  for (int i = 0; i < FloorSteps; ++i)
  {
    const double middle = 0.5 * (low + high);
    camera->SetParallelScale(std::exp(middle));
    entry.Renderer->DrawOn();
    const long count = CountCovered(picture.Draw(this->Scene.FirstCells));
    entry.Renderer->DrawOff();
    (count >= pixels ? low : high) = middle;
    if (covered < 0 || std::abs(count - pixels) <= std::abs(covered - pixels))
    {
      covered = count;
      best = middle;
    }
  }
  camera->SetParallelScale(std::exp(best));
  CheckMessages(entry.Run);
  return covered;
}
}
}
