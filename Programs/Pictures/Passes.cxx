// SPDX-License-Identifier: BSD-3-Clause
#include "Passes.h"

#include <vtkCameraPass.h>
#include <vtkCullerCollection.h>
#include <vtkFrustumCoverageCuller.h>
#include <vtkLightsPass.h>
#include <vtkNew.h>
#include <vtkOpaquePass.h>
#include <vtkPanoramicProjectionPass.h>
#include <vtkRenderPassCollection.h>
#include <vtkRenderer.h>
#include <vtkSequencePass.h>
#include <vtkTranslucentPass.h>
#include <vtkWideFoVPass.h>

namespace widefov
{
vtkSmartPointer<vtkPanoramicProjectionPass> MakeCubeMapPass(const Options& o)
{
  vtkNew<vtkLightsPass> lights;
  vtkNew<vtkOpaquePass> opaque;
  vtkNew<vtkTranslucentPass> translucent;
  vtkNew<vtkRenderPassCollection> passes;
  passes->AddItem(lights);
  passes->AddItem(opaque);
  passes->AddItem(translucent);
  vtkNew<vtkSequencePass> sequence;
  sequence->SetPasses(passes);
  vtkNew<vtkCameraPass> camera;
  camera->SetDelegatePass(sequence);
  auto pass = vtkSmartPointer<vtkPanoramicProjectionPass>::New();
  pass->SetDelegatePass(camera);
  pass->SetCubeResolution(static_cast<unsigned int>(o.CubeMapResolution));
  pass->SetAngle(o.View.HorizontalFov);
  pass->SetInterpolate(true);
  if (o.Projection == "azimuthal-equidistant")
  {
    pass->SetProjectionTypeToAzimuthal();
  }
  else
  {
    pass->SetProjectionTypeToEquirectangular();
  }
  return pass;
}

void SetCubeMapPass(vtkRenderer* renderer, vtkPanoramicProjectionPass* pass)
{
  renderer->SetPass(pass);
  renderer->GetCullers()->RemoveAllItems();
}

void SetWidePass(vtkRenderer* renderer, vtkWideFoVPass* pass)
{
  renderer->SetPass(pass);
  if (renderer->GetCullers()->GetNumberOfItems() == 0)
  {
    renderer->AddCuller(vtkNew<vtkFrustumCoverageCuller>());
  }
}

bool DrawsPerspective(const Options& o)
{
  return o.ExactPerspective ||
    vtkWideFoVPass::IsExactTechnique(static_cast<int>(o.Technique), o.Tolerance);
}

void SetUpWidePass(vtkWideFoVPass* pass, const Options& o)
{
  pass->SetTechnique(static_cast<int>(o.Technique));
  pass->SetTolerance(o.Tolerance);
  pass->SetDebugView(o.DebugView);
  pass->SetShaderFolder(o.DumpShaders.c_str());
}
}
