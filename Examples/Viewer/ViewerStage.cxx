// SPDX-License-Identifier: BSD-3-Clause
#include "ViewerStage.h"

#include "Borders.h"
#include "CameraSetup.h"
#include "Display.h"
#include "Frame.h"
#include "Messages.h"
#include "Passes.h"
#include "SkyPicture.h"
#include "StereoChoice.h"
#include "StereoLayout.h"
#include "StereoOptions.h"
#include "Tiles.h"
#include "Volume.h"

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
}

FrameCost operator+(const FrameCost& a, const FrameCost& b)
{
  FrameCost sum{ a.Milliseconds + b.Milliseconds, b.Draws };
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
  this->Window->SetMultiSamples(UsableSamples(o.Samples, limits));
  this->Window->SetNumberOfLayers(3);
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
  this->Window->SetDesiredUpdateRate(rate > 0 ? rate : StillRate);
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
  this->Start = std::chrono::steady_clock::now();
  if (this->InTurn)
  {
    this->SetText(); // the same for both eyes: what the frame before took
  }
  this->EyeShown = 0;
  this->Window->Render();
  this->HasFrame = true;
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
