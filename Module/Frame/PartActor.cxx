// SPDX-License-Identifier: BSD-3-Clause
#include "Frame/PartActor.h"

#include "Frame/PropKeys.h"
#include "Frame/Stages.h"

#include "vtkOpenGLActor.h"
#include "vtkRenderer.h"

namespace wfv
{
namespace
{
thread_local FrameInDrawing* Innermost = nullptr;
}

Stages* FindFrame(vtkRenderer* renderer)
{
  for (FrameInDrawing* frame = Innermost; frame; frame = frame->Before)
  {
    if (frame->Renderer == renderer)
    {
      return frame->Found;
    }
  }
  return nullptr;
}

bool IsFrameInDrawing()
{
  return Innermost && Innermost->Found;
}

FrameInDrawing::FrameInDrawing(vtkRenderer* renderer, Stages* stages)
  : Before(Innermost)
  , Renderer(renderer)
  , Found(stages)
{
  Innermost = this;
}

FrameInDrawing::~FrameInDrawing()
{
  Innermost = this->Before;
}

namespace
{
// Without a name of its own: whoever asks sees the class that it stands for.
class PartActor : public vtkOpenGLActor
{
public:
  static PartActor* New()
  {
    auto* const made = new PartActor;
    made->InitializeObjectBase();
    return made;
  }

  void Render(vtkRenderer* renderer, vtkMapper* mapper) override
  {
    Stages* const stages = FindFrame(renderer);
    PropTraits traits;
    if (stages && stages->IsLeftOut(this, traits))
    {
      return;
    }
    if (!stages || Stages::FindAttached(this))
    {
      this->vtkOpenGLActor::Render(renderer, mapper);
      return;
    }
    const double* const bounds = this->GetBounds();
    if (stages->IsCulled(this, bounds, traits))
    {
      return;
    }
    vtkWideFoVStage* const stage = stages->Choose(this, bounds, traits);
    this->Keys.Attach(this, stage);
    this->vtkOpenGLActor::Render(renderer, mapper);
    this->Keys.Detach(this, stage);
  }

protected:
  vtkObjectBase* NewInstanceInternal() const override { return PartActor::New(); }

private:
  PropKeys Keys;
};
}

vtkObject* MakePartActor()
{
  return PartActor::New();
}

bool FindsItsFrame(vtkObject* actor)
{
  return dynamic_cast<PartActor*>(actor) != nullptr;
}
}
