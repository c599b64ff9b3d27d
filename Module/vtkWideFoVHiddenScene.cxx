// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWideFoVHiddenScene.h"

#include "vtkRenderer.h"

#include <atomic>

namespace
{
// Frames after which nobody looks at depths any more.
constexpr int Kept = 8;
}

namespace wfv
{
std::uint64_t HiddenScene::MakeNumber()
{
  static std::atomic<std::uint64_t> last{ 0 };
  return ++last;
}

void HiddenScene::Begin(const vtkProp* last, std::uint64_t view, int wait)
{
  const bool same =
    this->Number > 0 && last == this->LastProp && view == this->View && this->Coming == this->Last;
  this->Wait = wait;
  if (++this->Unasked == Kept)
  {
    for (auto& picture : this->Pictures)
    {
      picture.Depths = DepthPicture();
      picture.Number = 0;
    }
    this->Rays.Clear();
  }
  if (last && same)
  {
    this->Frames++;
    return;
  }
  this->Number = last ? MakeNumber() : 0;
  this->LastProp = last;
  this->View = view;
  this->Last.swap(this->Coming);
  this->Frames = 0;
  this->Asked = false;
  this->Rays.Clear();
}

const SampleRays& HiddenScene::GetRays(const SortView& view)
{
  if (this->Rays.IsEmpty())
  {
    this->Rays.Make(view);
  }
  return this->Rays;
}

const DepthPicture* HiddenScene::AskFor(int eye)
{
  if (this->Number == 0 || this->Frames < this->Wait)
  {
    return nullptr;
  }
  this->Unasked = 0;
  const auto& picture = this->Pictures[eye + 1];
  const bool known = picture.Number == this->Number && !picture.Depths.IsEmpty();
  this->Asked = this->Asked || picture.Number != this->Number;
  return known ? &picture.Depths : nullptr;
}

void HiddenScene::EndProp(const vtkProp* prop, vtkRenderer* renderer, int eye)
{
  auto& picture = this->Pictures[eye + 1];
  if (!this->Asked || this->Paused || prop != this->LastProp || picture.Number == this->Number)
  {
    return;
  }
  int part[4];
  renderer->GetTiledSizeAndOrigin(&part[2], &part[3], &part[0], &part[1]);
  picture.Depths.Read(part);
  picture.Number = this->Number;
}
}
