// SPDX-License-Identifier: BSD-3-Clause
#include "RenderJob.h"

#include "Aov.h"
#include "Options/OutputNames.h"
#include "Options/StereoChoice.h"
#include "Options/StereoLayout.h"
#include "Pictures/CameraSetup.h"
#include "Pictures/Frame.h"
#include "Pictures/Passes.h"
#include "Pictures/PictureFiles.h"
#include "Pictures/ScalarBar.h"
#include "Pictures/SkyPicture.h"
#include "Pictures/StereoWindow.h"
#include "Pictures/StripFile.h"
#include "Pictures/Tiles.h"
#include "Pictures/Warp.h"
#include "Scenes/ShownScene.h"
#include "System/Progress.h"
#include "Text/Messages.h"

#include <vtkNew.h>
#include <vtkPanoramicProjectionPass.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
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
// Rows of a tile of float channels at the most: a row of tiles waits in memory.
constexpr int AovTileHeight = 256;

// Everything that lives as long as the window.
struct Stage
{
  vtkNew<vtkRenderWindow> Window;
  vtkSmartPointer<vtkRenderer> Renderer;
  vtkNew<vtkWideFoVPass> WidePass;
  ShownScene Shown;
  std::vector<int> StereoTypes; // one a traversal of a frame; none: mono
  vtkSmartPointer<vtkProp> Bar;
  vtkSmartPointer<vtkProp> Overlay;
  std::optional<TileGrid> Tiles;
  int ProgramsAtFirst = 0; // made before frames were timed
};

void Fill(Stage& stage, const Scene& scene, const Options& o)
{
  if (o.Technique == Technique::CubeMap)
  {
    stage.Renderer = vtkSmartPointer<vtkRenderer>::New();
    SetCubeMapPass(stage.Renderer, MakeCubeMapPass(o));
  }
  else
  {
    stage.Renderer = vtkSmartPointer<vtkWideFoVRenderer>::New();
    SetUpWidePass(stage.WidePass, o);
    stage.Renderer->SetPass(stage.WidePass);
  }
  SetBackground(stage.Renderer, o);
  stage.Shown = ShowScene(stage.Renderer, scene, o.Look);
  stage.Bar = AddScalarBar(stage.Renderer, scene, o);
  stage.Overlay = AddOverlay(stage.Renderer, stage.WidePass, o, stage.Tiles.has_value());
  SetCamera(stage.Renderer, scene, o);
  if (HasTwoEyes(o))
  {
    stage.StereoTypes = FindStereoLayout(o.Layout).Types;
    SetAnaglyph(stage.Window, o);
    AddStereoWindow(stage.Renderer, o);
  }
  stage.Window->AddRenderer(stage.Renderer);
  const std::array<int, 2>& size = stage.Tiles ? stage.Tiles->Tile : o.Size;
  stage.Window->SetSize(size[0], size[1]);
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

// Draws what there is to see once, with neither eye.
void Converge(Stage& stage, const Options& o)
{
  if (!o.ConvergeOnDepth)
  {
    return;
  }
  stage.Window->StereoRenderOff();
  stage.Window->Render();
  CheckMessages();
  auto* const camera = vtkWideFoVCamera::SafeDownCast(stage.Renderer->GetActiveCamera());
  if (!camera->ConvergeOnDepth(stage.Renderer))
  {
    Say("warning: nothing is seen to converge on; the usual number is kept");
  }
}

std::size_t CountEyes(const Stage& stage)
{
  return std::max<std::size_t>(1, stage.StereoTypes.size());
}

// Of what the window shows: milliseconds.
double DrawTimed(Stage& stage, std::size_t eye)
{
  const auto start = std::chrono::steady_clock::now();
  Draw(stage, eye);
  stage.Window->WaitForCompletion();
  const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
  return time.count();
}

// Of all eyes and tiles.
double RenderFrame(Stage& stage)
{
  double time = 0;
  const int columns = stage.Tiles ? stage.Tiles->Count(0) : 1;
  const int rows = stage.Tiles ? stage.Tiles->Count(1) : 1;
  for (int tile = 0; tile < rows * columns; tile++)
  {
    if (stage.Tiles)
    {
      ShowTile(*stage.Tiles, stage.Window, tile % columns, tile / columns);
    }
    for (std::size_t i = 0; i < CountEyes(stage); i++)
    {
      time += DrawTimed(stage, i);
    }
  }
  return time;
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
    stats.Shaders.FirstFrame = stats.Shaders.FirstFrame.value_or(milliseconds);
    if (i + 1 == warmUps)
    {
      stage.ProgramsAtFirst = stage.WidePass->GetNumberOfMadePrograms();
    }
    progress.Update(double(i + 1) / total);
    if (i >= warmUps)
    {
      stats.Milliseconds.push_back(milliseconds);
    }
  }
}

// The last frame's, or, where it took several, drawn again.
std::vector<Picture> ReadPictures(Stage& stage)
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
  return eyes;
}

// Makes the renderer draw into the pass, at pixel centres, what is a surface.
void SetUpAov(Stage& stage, vtkWideFoVDataPass* pass)
{
  pass->SetDelegatePass(stage.WidePass);
  for (std::size_t i = 0; i < stage.Shown.Actors.size(); i++)
  {
    // every actor has cells of its own; NumberByFile makes one of those of one file
    pass->SetPropIndex(stage.Shown.Actors[i], static_cast<int>(i));
  }
  for (vtkVolume* const volume : stage.Shown.Volumes)
  {
    volume->VisibilityOff(); // nor has it one
  }
  for (vtkProp* const prop : { stage.Bar.Get(), stage.Overlay.Get() })
  {
    if (prop)
    {
      prop->VisibilityOff(); // it is no surface
    }
  }
  stage.Window->SetMultiSamples(0);
  stage.Renderer->SetPass(pass);
}

FloatPicture RenderAov(Stage& stage, const Scene& scene)
{
  const Progress progress("drawing the float channels");
  vtkNew<vtkWideFoVDataPass> pass;
  SetUpAov(stage, pass);
  stage.Window->Render();
  CheckMessages();
  FloatPicture picture = FlattenAov(pass->GetOutput(), scene);
  stage.Renderer->SetPass(stage.WidePass);
  pass->ReleaseGraphicsResources(stage.Window);
  return picture;
}

// Where the module draws, not stock VTK.
bool IsWide(Stage& stage)
{
  auto* const camera = vtkWideFoVCamera::SafeDownCast(stage.Renderer->GetActiveCamera());
  return camera != nullptr && camera->IsWide();
}

void Count(Stage& stage, const Options& o, RenderStats& stats)
{
  stats.Gl = QueryStrings(stage.Window);
  stats.PropsTotal = static_cast<int>(stage.Shown.Actors.size());
  if (IsWide(stage)) // otherwise stock VTK draws, and does not count
  {
    const int others =
      (stage.Bar ? 1 : 0) + (o.Overlay ? 1 : 0) + (o.FloatingWindow > 0 || o.Letterbox > 0 ? 1 : 0);
    TakeCounts(stage.WidePass, others, stats);
    TakeShaders(stage.WidePass, stage.ProgramsAtFirst, stats);
  }
}

// Of a picture in tiles the last frame is one of many.
void CountTiles(Stage& stage, RenderStats& stats)
{
  const RenderStats all = stats;
  stats = RenderStats();
  stats.Gl = QueryStrings(stage.Window);
  stats.Milliseconds = all.Milliseconds;
  stats.PropsTotal = static_cast<int>(stage.Shown.Actors.size());
  stats.Tiles = { { stage.Tiles->Count(0), stage.Tiles->Count(1) } };
  stats.Shaders = all.Shaders;
  if (IsWide(stage))
  {
    TakeShaders(stage.WidePass, stage.ProgramsAtFirst, stats);
  }
}

std::vector<std::unique_ptr<StripFile>> OpenPictures(const Options& o, OutputFiles& files)
{
  const std::array<int, 2> size = SizeOfFile(o);
  const PanoramaInfo info = DescribePanorama(o);
  std::vector<std::unique_ptr<StripFile>> pictures;
  for (const std::string& output : o.Outputs)
  {
    for (const std::string& name : FilesOf(o, output))
    {
      pictures.push_back(std::make_unique<StripFile>(files, name, size[0], size[1], info));
    }
  }
  return pictures;
}

void CloseAll(const std::vector<std::unique_ptr<StripFile>>& pictures)
{
  for (const std::unique_ptr<StripFile>& picture : pictures)
  {
    picture->Close();
  }
}

bool HasPictures(const Options& o)
{
  return !o.Outputs.empty() || !o.Web.empty();
}

// Adds rows to the picture of an eye, which a web page is made from.
void Keep(const Options& o, const Picture& rows, std::size_t eye, std::vector<Picture>& pictures)
{
  if (o.Web.empty())
  {
    return;
  }
  pictures.resize(std::max(pictures.size(), eye + 1));
  Picture& picture = pictures[eye];
  picture.Width = rows.Width;
  picture.Height += rows.Height;
  picture.Rgb.insert(picture.Rgb.end(), rows.Rgb.begin(), rows.Rgb.end());
}

// The files of an output are beside each other.
void WriteTiledPictures(Stage& stage, const Options& o, OutputFiles& files, RenderResult& result)
{
  const std::vector<std::unique_ptr<StripFile>> pictures = OpenPictures(o, files);
  const std::size_t each = o.Outputs.empty() ? 1 : pictures.size() / o.Outputs.size();
  double time = 0;
  const auto draw = [&](std::size_t eye) {
    time += DrawTimed(stage, eye);
    CheckMessages();
  };
  std::vector<int> taken(CountEyes(stage), 0); // rows
  const auto take = [&](std::size_t i, const Picture& drawn) {
    Picture rows = drawn;
    ApplyLight(o, rows, taken[i]);
    Keep(o, rows, i, result.Tiled);
    taken[i] += rows.Height;
    for (std::size_t k = i; k < pictures.size(); k += each)
    {
      pictures[k]->Add(rows.Rgb.data(), rows.Height);
    }
  };
  DrawTiles(*stage.Tiles, o, stage.Window, CountEyes(stage), draw, take);
  if (result.Stats.Milliseconds.empty())
  {
    result.Stats.Milliseconds.push_back(time);
  }
  CloseAll(pictures);
}

void WriteTiledAov(Stage& stage, const Scene& scene, const Options& o, OutputFiles& files)
{
  Progress progress("drawing the float channels in tiles");
  TileGrid& grid = *stage.Tiles;
  grid.Tile[1] = std::min(grid.Tile[1], AovTileHeight);
  SetTiles(grid, stage.Window, stage.Renderer);
  vtkNew<vtkWideFoVDataPass> pass;
  SetUpAov(stage, pass);
  StripFile file(files, o.Aov, o.Size[0], o.Size[1], AovChannels(), DescribePanorama(o));
  FloatPicture band;
  band.Width = grid.Picture[0];
  band.Channels = AovChannels();
  for (int row = 0; row < grid.Count(1); row++)
  {
    band.Height = grid.Rows(row);
    band.Values.resize(band.Channels.size() * band.Width * band.Height);
    for (int column = 0; column < grid.Count(0); column++)
    {
      ShowTile(grid, stage.Window, column, row);
      stage.Window->Render();
      CheckMessages();
      const FloatPicture tile = FlattenAov(pass->GetOutput(), scene);
      CopyBeside(tile, column * grid.Tile[0], band);
    }
    file.Add(band.Values.data(), band.Height);
    progress.Update((row + 1.0) / grid.Count(1));
  }
  file.Close();
  stage.Renderer->SetPass(stage.WidePass);
  pass->ReleaseGraphicsResources(stage.Window);
}

RenderResult RenderTiled(Stage& stage, const Scene& scene, const Options& o, OutputFiles& files)
{
  RenderResult result;
  SetTiles(*stage.Tiles, stage.Window, stage.Renderer);
  const bool drawn = o.Frames > 0;
  if (drawn)
  {
    RenderFrames(stage, o, result.Stats);
  }
  if (HasPictures(o) || (!drawn && (!o.Stats.empty() || !o.DumpShaders.empty())))
  {
    WriteTiledPictures(stage, o, files, result);
  }
  CountTiles(stage, result.Stats);
  if (!o.Aov.empty())
  {
    WriteTiledAov(stage, scene, o, files);
  }
  return result;
}

RenderResult DrawAll(const Scene& scene, const Options& o, OutputFiles& files)
{
  const DisplayConnection display;
  Stage stage;
  OpenWindow(stage.Window);
  const GlLimits limits = QueryLimits(stage.Window);
  stage.Tiles = PlanTiles(o, limits);
  if (!stage.Tiles)
  {
    CheckSize(o, limits);
  }
  stage.Window->SetMultiSamples(UsableSamples(o.Samples, limits));
  const QuietStandardError quiet;
  Fill(stage, scene, o);
  if (stage.Tiles)
  {
    return RenderTiled(stage, scene, o, files);
  }
  RenderResult result;
  Converge(stage, o);
  RenderFrames(stage, o, result.Stats);
  Count(stage, o, result.Stats);
  if (HasPictures(o))
  {
    result.Colors = ReadPictures(stage);
  }
  if (!o.Aov.empty())
  {
    result.Aov = RenderAov(stage, scene);
  }
  CheckMessages();
  return result;
}
}

RenderResult Render(const Scene& scene, const Options& o, OutputFiles& files)
{
  const Stopwatch watch;
  RenderResult result = DrawAll(scene, o, files);
  PartTimes& parts = result.Stats.Parts;
  parts.Drawing = watch.GetMilliseconds() - parts.Clusters.value_or(0) - parts.Shaders.value_or(0);
  return result;
}
}
