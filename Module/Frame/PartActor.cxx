// SPDX-License-Identifier: BSD-3-Clause
#include "Frame/PartActor.h"

#include "Camera/Tile.h"
#include "Frame/PropKeys.h"
#include "Frame/Stages.h"
#include "vtkWideFoVCamera.h"

#include "vtkMatrix4x4.h"
#include "vtkNew.h"
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

LabelUp FindLabelUp()
{
  return Innermost ? Innermost->Up : LabelUp::Picture;
}

FrameInDrawing::FrameInDrawing(vtkRenderer* renderer, Stages* stages, LabelUp up)
  : Before(Innermost)
  , Renderer(renderer)
  , Found(stages)
  , Up(up)
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
    if (stages && !this->GetMapper())
    {
      this->FaceEye(renderer);
    }
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
  // A follower hands its matrix to an actor without a mapper of its own, before each drawing.
  void FaceEye(vtkRenderer* renderer)
  {
    auto* const camera = vtkWideFoVCamera::SafeDownCast(renderer->GetActiveCamera());
    vtkMatrix4x4* const matrix = this->GetUserMatrix();
    vtkNew<vtkMatrix4x4> turned;
    if (camera && matrix)
    {
      turned->DeepCopy(matrix);
      if (TurnFollower(turned, camera, PictureAspect(renderer)))
      {
        this->SetUserMatrix(turned);
      }
    }
  }

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
