// SPDX-License-Identifier: BSD-3-Clause
#include "ViewerStage.h"

#include "Options/StereoChoice.h"
#include "Options/StereoLayout.h"
#include "Pictures/CameraSetup.h"
#include "Pictures/Frame.h"
#include "Pictures/Passes.h"
#include "Pictures/ScalarBar.h"
#include "Pictures/SkyPicture.h"
#include "Pictures/StereoWindow.h"
#include "Pictures/Tiles.h"
#include "Scenes/Volume.h"
#include "System/Display.h"
#include "Text/Messages.h"

#include <Gl.h>
#include <vtkOpenGLState.h>
#include <vtkPanoramicProjectionPass.h>
#include <vtkRenderWindow.h>
#include <vtkWideFoVCamera.h>

#include <algorithm>

namespace widefov
{
namespace
{
// Smaller windows show no text; pixels. In very small ones VTK's text is an error.
constexpr std::array<int, 2> TextRoom{ { 64, 32 } };

// Frames a second: what VTK's interactors ask for when nothing moves.
constexpr double StillRate = 0.0001;

// Of the time of a frame, what the scene may take; the rest is for showing it. VTK shares it out to
// as many layers, of which the others are done at once.
constexpr double SceneShare = 0.7;
constexpr int Layers = 3;

// Of the time that a moving frame has, what a still one takes at least where fewer triangles are
// drawn: fewer pixels alone save less.
constexpr double FewerFrom = 2;

// Triangles and lines of a coarse scene: the share of those that would take the time, for other
// things take some; and where a scene is not made out.
constexpr double ShareOfTime = 0.5;
constexpr long long FewestCells = 20000;
}

FrameCost operator+(const FrameCost& a, const FrameCost& b)
{
  FrameCost sum{ a.Milliseconds + b.Milliseconds, b.Draws, a.Coarse || b.Coarse };
  if (a.Draws && b.Draws)
  {
    const DrawCounts& x = *a.Draws;
    const DrawCounts& y = *b.Draws;
    sum.Draws = DrawCounts{ x.Plain + y.Plain, x.PreClip + y.PreClip, x.Tessellate + y.Tessellate,
      x.Exact + y.Exact, x.Props + y.Props, x.PropsCulled + y.PropsCulled,
      x.Triangles + y.Triangles, x.TrianglesCulled + y.TrianglesCulled,
      x.TrianglesProjected + y.TrianglesProjected, std::max(x.Relaxation, y.Relaxation) };
  }
  return sum;
}

ViewerStage::ViewerStage(GLFWwindow* window, bool stereo, const Options& o, const Tile& tile)
  : Where(tile)
{
  this->Window->SetWindow(window, stereo);
  CheckMessages();
  const GlLimits limits = QueryLimits(this->Window);
  this->Limits = { { limits.Width, limits.Height } };
  CheckSize(o, limits);
  this->Samples = UsableSamples(o.Samples, limits);
  this->Window->SetMultiSamples(this->Samples);
  this->Window->SetNumberOfLayers(Layers);
  this->ShowTile();
  SetBackground(this->Renderer, o);
  this->Renderer->AddObserver(vtkCommand::EndEvent, this, &ViewerStage::AfterScene);
  this->Window->AddRenderer(this->Renderer);
  this->Window->AddRenderer(this->Cross.GetRenderer());
  this->Window->AddRenderer(this->Texts.GetRenderer());
}

ViewerStage::~ViewerStage()
{
  this->Window->MakeCurrent();
  this->Window->Finalize();
}

void ViewerStage::SetScene(const Scene& scene, const Look& look)
{
  this->Window->MakeCurrent();
  HideScene(this->Renderer, this->Shown);
  HideScene(this->Renderer, this->ShownCoarse);
  this->Coarse = Scene();
  this->IsCoarseNow = false;
  this->Style = look;
  this->What = &scene;
  this->Shown = ShowScene(this->Renderer, scene, look);
  if (this->Bar)
  {
    this->Renderer->RemoveViewProp(this->Bar);
  }
  this->Bar = MakeScalarBar(scene);
  if (this->Bar)
  {
    this->Renderer->AddViewProp(this->Bar);
  }
}

void ViewerStage::SetVolumeOpacity(double factor)
{
  for (vtkVolume* const volume : this->Shown.Volumes)
  {
    SetOpacity(volume, factor);
  }
}

void ViewerStage::ApplyCubeMap(const Options& o)
{
  const std::string wanted = o.Projection + " " + Text(o.View.HorizontalFov);
  if (!this->CubeMapPass || this->CubeMapOf != wanted)
  {
    if (this->CubeMapPass)
    {
      this->CubeMapPass->ReleaseGraphicsResources(this->Window);
    }
    this->CubeMapPass = MakeCubeMapPass(o);
    this->CubeMapOf = wanted;
  }
  SetCubeMapPass(this->Renderer, this->CubeMapPass);
}

void ViewerStage::ShowTile()
{
  const Tile& t = this->Where;
  this->Window->SetTileScale(t.Columns, t.Rows);
  this->Window->SetTileViewport(double(t.Column) / t.Columns, double(t.Rows - 1 - t.Row) / t.Rows,
    double(t.Column + 1) / t.Columns, double(t.Rows - t.Row) / t.Rows);
}

// The window's tile, or the part of a larger picture.
void ViewerStage::PlaceIn(const Options& o, const std::array<int, 2>& size)
{
  if (!o.Part)
  {
    this->ShowTile();
    this->Window->SetSize(size[0], size[1]);
    this->Renderer->SetViewport(0, 0, 1, 1);
    this->Texts.GetRenderer()->SetViewport(0, 0, 1, 1);
  }
  else
  {
    ShowPart(o, this->Window, this->Renderer);
    this->Texts.GetRenderer()->SetViewport(this->Window->GetTileViewport());
  }
  this->Cross.GetRenderer()->SetViewport(this->Renderer->GetViewport());
}

void ViewerStage::Apply(const Options& o, const std::array<int, 2>& size)
{
  this->PlaceIn(o, size);
  if (o.Technique == Technique::CubeMap)
  {
    this->ApplyCubeMap(o);
  }
  else
  {
    SetUpWidePass(this->WidePass, o);
    SetWidePass(this->Renderer, this->WidePass);
  }
  this->Renderer->SetBackground(o.Background[0], o.Background[1], o.Background[2]);
  SetCamera(this->Renderer, *this->What, o);
  SetCamera(this->Cross.GetRenderer(), *this->What, o);
  this->InTurn = false;
  if (HasTwoEyes(o))
  {
    const StereoLayout& layout = FindStereoLayout(o.Layout);
    this->InTurn = layout.InTurn;
    this->Window->SetStereoType(layout.InTurn ? VTK_STEREO_CRYSTAL_EYES : layout.Types.front());
    SetAnaglyph(this->Window, o);
  }
  this->Window->SetStereoRender(HasTwoEyes(o));
}

bool ViewerStage::HasRoom()
{
  const int* const size = this->Window->GetActualSize();
  return size[0] >= TextRoom[0] && size[1] >= TextRoom[1];
}

void ViewerStage::SetText()
{
  const int* const size = this->Window->GetActualSize();
  this->Texts.SetText(
    this->TextOf && this->HasRoom() ? this->TextOf(this->Cost) : "", size[0], size[1]);
}

// Of two eyes the left one is drawn first: it is the one that the pointer is seen by.
void ViewerStage::SetCrosshair()
{
  if (this->Aiming != nullptr && this->Aiming->Pointer && !this->Aimed)
  {
    Crosshair::Find(this->Renderer, *this->Aiming);
  }
  this->Aimed = true;
  this->Cross.Show(this->Aiming);
}

// After the scene and before the crosshair and the text, which is to tell of this very frame.
void ViewerStage::AfterScene()
{
  this->SetCrosshair();
  this->Cost = this->Measure();
  if (!this->InTurn)
  {
    this->SetText();
  }
}

void ViewerStage::SetUpdateRate(double rate)
{
  this->WidePass->SetKeepUpdateRate(rate > 0);
  this->Window->SetDesiredUpdateRate(rate > 0 ? rate / (SceneShare * Layers) : StillRate);
  if ((rate > 0) != this->Moves)
  {
    this->Moves = rate > 0;
    this->GiveWay(rate);
  }
}

// For all of a motion, so that nothing flickers. Samples cost where they are put together, too,
// which the pass does not see.
void ViewerStage::GiveWay(double rate)
{
  const double times = this->StillCost * rate / 1000; // as long as there is time for
  this->HasFewer = this->Samples > 0 && times > 1;
  this->Window->SetMultiSamples(this->HasFewer ? 0 : this->Samples);
  const PrimitiveCount count = CountPrimitives(*this->What);
  const long long cells = count.Triangles + count.Lines;
  const bool coarse = times > FewerFrom && cells > FewestCells;
  if (coarse && this->ShownCoarse.Actors.empty())
  {
    const auto most = static_cast<long long>(ShareOfTime * static_cast<double>(cells) / times);
    this->Coarse = MakeCoarse(*this->What, std::max(most, FewestCells));
    this->Coarse.Volumes.clear();
    this->ShownCoarse = ShowScene(this->Renderer, this->Coarse, this->Style);
    this->IsNew = true;
  }
  this->ShowCoarse(coarse);
}

void ViewerStage::ShowCoarse(bool coarse)
{
  this->IsCoarseNow = coarse;
  for (vtkActor* const actor : this->Shown.Actors)
  {
    actor->SetVisibility(!coarse);
  }
  for (vtkActor* const actor : this->ShownCoarse.Actors)
  {
    actor->SetVisibility(coarse);
  }
}

// The first frame of a coarse scene loads it and compiles, and says nothing of what the next ones
// take.
void ViewerStage::DrawFirst()
{
  if (this->IsNew && this->IsCoarseNow)
  {
    this->IsNew = false;
    this->WidePass->KeepUpdateRateOff();
    this->Window->Render();
    this->WidePass->KeepUpdateRateOn();
  }
}

void ViewerStage::Flip()
{
  this->EyeShown = 1 - this->EyeShown;
  this->Window->ShowEye(this->EyeShown);
}

FrameCost ViewerStage::Measure()
{
  this->Window->WaitForCompletion();
  const std::chrono::duration<double, std::milli> time =
    std::chrono::steady_clock::now() - this->Start;
  FrameCost cost;
  cost.Milliseconds = time.count();
  cost.Coarse = this->HasFewer || this->IsCoarseNow;
  auto* const camera = vtkWideFoVCamera::SafeDownCast(this->Renderer->GetActiveCamera());
  if (camera != nullptr && camera->IsWide())
  {
    vtkWideFoVPass* const pass = this->WidePass;
    cost.Draws = DrawCounts{ pass->GetNumberOfProjectedDraws(), pass->GetNumberOfPreClipDraws(),
      pass->GetNumberOfTessellateDraws(), pass->GetNumberOfExactDraws(),
      pass->GetNumberOfDrawnProps(), pass->GetNumberOfCulledProps(), pass->GetNumberOfTriangles(),
      pass->GetNumberOfCulledTriangles(), pass->GetNumberOfProjectedTriangles(),
      pass->GetRelaxation() };
  }
  return cost;
}

FrameCost ViewerStage::Draw(const Options& o, const std::array<int, 2>& size,
  const std::function<std::string(const FrameCost&)>& text, const std::string& help, Aim* aim)
{
  this->TextOf = text;
  this->Aiming = o.Technique != Technique::CubeMap ? aim : nullptr;
  this->Aimed = false;
  this->Apply(o, size);
  if (this->Bar)
  {
    PlaceBar(this->Bar, o);
    this->Bar->SetVisibility(this->HasRoom());
  }
  this->Texts.SetHelp(this->HasRoom() ? help : "", size[0], size[1]);
  this->DrawFirst();
  this->Start = std::chrono::steady_clock::now();
  if (this->InTurn)
  {
    this->SetText(); // the same for both eyes: what the frame before took
  }
  this->EyeShown = 0;
  this->Window->Render();
  this->HasFrame = true;
  this->StillCost = this->Moves ? this->StillCost : this->Cost.Milliseconds;
  CheckMessages();
  return this->Cost;
}

void ViewerStage::ShowAgain()
{
  if (this->HasFrame)
  {
    this->Window->ShowEye(this->EyeShown);
    return;
  }
  this->Window->DrawOver([this] {
    vtkOpenGLState* const state = this->Window->GetState();
    state->vtkglClearColor(0, 0, 0, 1);
    state->vtkglClear(GL_COLOR_BUFFER_BIT);
  });
}

Picture ViewerStage::Take(const Options& o, const std::array<int, 2>& size)
{
  this->Draw(o, size, nullptr, "");
  return ReadPicture(this->Window);
}
}
