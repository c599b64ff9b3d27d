// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWideFoVOverrides.h"

#include "vtkObjectFactory.h"
#include "vtkSmartPointer.h"
#include "vtkVersion.h"
#include "vtkWideFoVCamera.h"
#include "vtkWideFoVRenderer.h"

namespace
{
VTK_CREATE_CREATE_FUNCTION(vtkWideFoVCamera);
VTK_CREATE_CREATE_FUNCTION(vtkWideFoVRenderer);

class Factory : public vtkObjectFactory
{
public:
  static Factory* New()
  {
    auto* factory = new Factory;
    factory->InitializeObjectBase();
    return factory;
  }
  vtkTypeMacro(Factory, vtkObjectFactory);

  const char* GetVTKSourceVersion() override { return VTK_SOURCE_VERSION; }
  const char* GetDescription() override { return "WideFoV view"; }

private:
  Factory()
  {
    this->RegisterOverride("vtkCamera", "vtkWideFoVCamera", "wide field of view", 1,
      vtkObjectFactoryCreatevtkWideFoVCamera);
    this->RegisterOverride("vtkRenderer", "vtkWideFoVRenderer", "wide field of view", 1,
      vtkObjectFactoryCreatevtkWideFoVRenderer);
  }
};

int Depth = 0;
vtkSmartPointer<Factory> Current;

// The factory that comes first wins, and that of the OpenGL backend does.
void EnableStock(bool enable)
{
  vtkObjectFactory::SetAllEnableFlags(enable, "vtkCamera", "vtkOpenGLCamera");
  vtkObjectFactory::SetAllEnableFlags(enable, "vtkRenderer", "vtkOpenGLRenderer");
}
}

vtkWideFoVOverrides::vtkWideFoVOverrides()
{
  if (Depth++ == 0)
  {
    Current = vtkSmartPointer<Factory>::New();
    vtkObjectFactory::RegisterFactory(Current);
    EnableStock(false);
  }
}

vtkWideFoVOverrides::~vtkWideFoVOverrides()
{
  if (--Depth == 0)
  {
    EnableStock(true);
    vtkObjectFactory::UnRegisterFactory(Current);
    Current = nullptr;
  }
}
