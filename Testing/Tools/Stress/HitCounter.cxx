// SPDX-License-Identifier: BSD-3-Clause
#include "HitCounter.h"

#include "vtkWideFoVCamera.h"
#include "vtkWideFoVPass.h"
#include "vtkWideFoVPolyDataMapper.h"
#include "vtkWideFoVRenderer.h"

#include <vtkActor.h>
#include <vtkCameraPass.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOpaquePass.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkPolyData.h>
#include <vtkOpenGLPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderState.h>
#include <vtkUnsignedCharArray.h>
#include <Gl.h>

namespace wfv
{
namespace stress
{
namespace
{
// Opaque props, each fragment added to what is there.
class AddingPass : public vtkOpaquePass
{
public:
  static AddingPass* New();
  vtkTypeMacro(AddingPass, vtkOpaquePass);

  void Render(const vtkRenderState* s) override
  {
    auto* window = vtkOpenGLRenderWindow::SafeDownCast(s->GetRenderer()->GetRenderWindow());
    vtkOpenGLState* state = window->GetState();
    vtkOpenGLState::ScopedglEnableDisable depth(state, GL_DEPTH_TEST);
    vtkOpenGLState::ScopedglEnableDisable blend(state, GL_BLEND);
    vtkOpenGLState::ScopedglBlendFuncSeparate function(state);
    state->vtkglDisable(GL_DEPTH_TEST);
    state->vtkglEnable(GL_BLEND);
    state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
    this->Superclass::Render(s);
  }
};
vtkStandardNewMacro(AddingPass);
}

struct HitCounter::Internals
{
  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkWideFoVRenderer> Renderer;
  vtkNew<vtkWideFoVCamera> Camera;
  vtkNew<vtkWideFoVPass> Pass;
  vtkNew<vtkCameraPass> CameraPass;
  vtkNew<AddingPass> Adding;
  vtkNew<vtkOpenGLPolyDataMapper> Mapper;
  vtkNew<vtkWideFoVPolyDataMapper> WideMapper; // refines triangles
  vtkNew<vtkActor> Actor;
};

HitCounter::HitCounter()
  : Internal(new Internals)
{
  Internals& in = *this->Internal;
  in.Window->SetOffScreenRendering(1);
  in.Window->SetMultiSamples(0);
  in.Window->AddRenderer(in.Renderer);
  in.Renderer->SetActiveCamera(in.Camera);
  in.Mapper->ScalarVisibilityOff();
  in.WideMapper->ScalarVisibilityOff();
  in.Actor->GetProperty()->LightingOff();
  in.Actor->GetProperty()->SetColor(1. / 255, 1. / 255, 1. / 255);
  in.Renderer->AddActor(in.Actor);
  in.CameraPass->SetDelegatePass(in.Adding);
  in.Pass->SetDelegatePass(in.CameraPass);
  in.Renderer->SetPass(in.Pass);
}

HitCounter::~HitCounter() = default;

std::vector<unsigned char> HitCounter::Count(
  vtkPolyData* mesh, const test::Shot& shot, int technique, double tolerance)
{
  Internals& in = *this->Internal;
  vtkPolyDataMapper* mapper = in.Mapper;
  if (technique == vtkWideFoVPass::AUTO)
  {
    mapper = in.WideMapper;
  }
  mapper->SetInputData(mesh);
  in.Actor->SetMapper(mapper);
  in.Pass->SetTechnique(technique);
  in.Pass->SetTolerance(tolerance);
  in.Window->SetSize(shot.Width, shot.Height);
  test::PlaceCamera(in.Camera, shot);
  in.Camera->SetExactPerspective(in.Pass->IsExact());
  in.Window->Render();
  vtkNew<vtkUnsignedCharArray> pixels;
  in.Window->GetPixelData(0, 0, shot.Width - 1, shot.Height - 1, 0, pixels);
  std::vector<unsigned char> counts;
  for (int j = shot.Height - 1; j >= 0 && pixels->GetNumberOfTuples() > 0; --j)
  {
    for (int i = 0; i < shot.Width; ++i)
    {
      counts.push_back(pixels->GetValue(3 * (vtkIdType(j) * shot.Width + i)));
    }
  }
  return counts;
}
}
}
