// SPDX-License-Identifier: BSD-3-Clause
#include "SightsStage.h"

#include "CameraSetup.h"
#include "Frame.h"
#include "Options/StereoChoice.h"
#include "Options/StereoLayout.h"
#include "Passes.h"
#include "ScalarBar.h"
#include "SkyPicture.h"
#include "StereoWindow.h"
#include "Tiles.h"

namespace widefov
{
std::size_t CountEyes(const Options& o)
{
  return !HasTwoEyes(o) ? 1 : FindStereoLayout(o.Layout).Types.size();
}

SightsStage::SightsStage(const Scene& scene, const Options& o)
{
  OpenWindow(this->Window);
  this->Limits = QueryLimits(this->Window);
  this->Window->SetMultiSamples(UsableSamples(o.Samples, this->Limits));
  SetUpWidePass(this->Pass, o);
  this->Renderer->SetPass(this->Pass);
  SetBackground(this->Renderer, o);
  this->SetScene(scene, o);
  AddOverlay(this->Renderer, this->Pass, o, false);
  AddStereoWindow(this->Renderer, o);
  this->Window->AddRenderer(this->Renderer);
}

void SightsStage::SetScene(const Scene& scene, const Options& o)
{
  HideScene(this->Renderer, this->Shown);
  this->Shown = ShowScene(this->Renderer, scene, o.Look);
  this->Renderer->RemoveViewProp(this->Bar);
  this->Bar = AddScalarBar(this->Renderer, scene, o);
  this->What = &scene;
}

void SightsStage::Draw(const Options& sight, std::size_t type)
{
  CheckSize(sight, this->Limits);
  ShowPart(sight, this->Window, this->Renderer);
  SetCamera(this->Renderer, *this->What, sight);
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
  for (std::size_t i = 0; i < CountEyes(sight); i++)
  {
    this->Draw(sight, i);
    pictures.push_back(ReadPicture(this->Window));
  }
  return pictures;
}
}
