// SPDX-License-Identifier: BSD-3-Clause
#include "Frame/PartActor.h"

#include "Compat/FutureConst.h"
#include "Frame/PartText.h"
#include "Frame/PropKeys.h"
#include "Frame/Stages.h"

#include "vtkObjectFactory.h"
#include "vtkObjectFactoryCollection.h"
#include "vtkOpenGLActor.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkVersion.h"

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

struct Override
{
  const char* Overridden;
  const char* Stock;
  vtkObject* (*Make)();
};

const Override Overrides[] = {
  { "vtkActor", "vtkOpenGLActor", []() -> vtkObject* { return PartActor::New(); } },
  { "vtkBillboardTextActor3D", "vtkOpenGLBillboardTextActor3D", &MakePartText },
};

class PartFactory : public vtkObjectFactory
{
public:
  vtkTypeMacro(PartFactory, vtkObjectFactory);
  static PartFactory* New()
  {
    auto* const made = new PartFactory;
    made->InitializeObjectBase();
    return made;
  }

  const char* GetVTKSourceVersion() VTK_FUTURE_CONST override { return VTK_SOURCE_VERSION; }
  const char* GetDescription() VTK_FUTURE_CONST override
  {
    return "actors and texts that wide views find within other props";
  }

protected:
  PartFactory()
  {
    for (const Override& each : Overrides)
    {
      this->RegisterOverride(
        each.Overridden, each.Stock, "finds the wide frame that it is drawn in", 1, each.Make);
    }
  }
};

// Of those who make stock ones the first is asked; what others make of their own stays theirs.
void PutFirst(vtkObjectFactory* own)
{
  vtkCollectionSimpleIterator it;
  vtkObjectFactoryCollection* const all = vtkObjectFactory::GetRegisteredFactories();
  all->InitTraversal(it);
  while (vtkObjectFactory* factory = all->GetNextObjectFactory(it))
  {
    for (const Override& each : Overrides)
    {
      if (factory != own)
      {
        factory->SetEnableFlag(0, each.Overridden, each.Stock);
      }
    }
  }
}
}

void MakePartsWide()
{
  static vtkSmartPointer<PartFactory> own = vtkSmartPointer<PartFactory>::Take(PartFactory::New());
  if (!vtkObjectFactory::GetRegisteredFactories()->IsItemPresent(own))
  {
    vtkObjectFactory::RegisterFactory(own);
  }
  PutFirst(own);
}

bool FindsItsFrame(vtkObject* actor)
{
  return dynamic_cast<PartActor*>(actor) != nullptr;
}
}

namespace
{
// When the library is loaded: before most programs make their first actor.
const bool MadeWide = (wfv::MakePartsWide(), true);
}
