// SPDX-License-Identifier: BSD-3-Clause
#include "Overrides.h"

#include "Compat/FutureConst.h"
#include "Frame/BlockClusters.h"
#include "Frame/PartActor.h"
#include "Frame/PartText.h"
#include "vtkWideFoVPolyDataMapper.h"

#include "vtkObjectFactory.h"
#include "vtkObjectFactoryCollection.h"
#include "vtkSmartPointer.h"
#include "vtkVersion.h"

namespace wfv
{
namespace
{
struct Override
{
  const char* Overridden;
  const char* Stock; // what it stands for
  const char* What;
  vtkObject* (*Make)();
};

const Override Overrides[] = {
  { "vtkActor", "vtkOpenGLActor", "finds the wide frame that it is drawn in", &MakePartActor },
  { "vtkBillboardTextActor3D", "vtkOpenGLBillboardTextActor3D",
    "finds the wide frame that it is drawn in", &MakePartText },
  { "vtkPolyDataMapper", "vtkOpenGLPolyDataMapper", "classifies the clusters of its mesh",
    []() -> vtkObject* { return vtkWideFoVPolyDataMapper::New(); } },
  { "vtkCompositePolyDataMapperDelegator", "vtkOpenGLCompositePolyDataMapperDelegator",
    "classifies the clusters of blocks", &MakeBlockDelegator },
};

class Factory : public vtkObjectFactory
{
public:
  vtkTypeMacro(Factory, vtkObjectFactory);
  static Factory* New()
  {
    auto* const made = new Factory;
    made->InitializeObjectBase();
    return made;
  }

  const char* GetVTKSourceVersion() VTK_FUTURE_CONST override { return VTK_SOURCE_VERSION; }
  const char* GetDescription() VTK_FUTURE_CONST override
  {
    return "actors, texts and mappers for wide views; elsewhere they are VTK's own";
  }

protected:
  Factory()
  {
    for (const Override& each : Overrides)
    {
      this->RegisterOverride(each.Overridden, each.Stock, each.What, 1, each.Make);
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

void RegisterOverrides()
{
  static vtkSmartPointer<Factory> own = vtkSmartPointer<Factory>::Take(Factory::New());
  if (!vtkObjectFactory::GetRegisteredFactories()->IsItemPresent(own))
  {
    vtkObjectFactory::RegisterFactory(own);
  }
  PutFirst(own);
}
}

namespace
{
// When the library is loaded: before most programs make their first actor.
const bool Registered = (wfv::RegisterOverrides(), true);
}
