// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWideFoVEyesAtOnce.h"

#include "vtkWideFoVPropFacts.h"

#include "vtkActor.h"
#include "vtkDataObject.h"
#include "vtkMapper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkShaderProperty.h"

#include <algorithm>

namespace
{
// VTK's window draws the right eye after the left one.
bool DrawsBoth(vtkRenderWindow* window)
{
  const int type = window->GetStereoType();
  return window->GetStereoRender() && type != VTK_STEREO_LEFT && type != VTK_STEREO_RIGHT &&
    type != VTK_STEREO_FAKE;
}

bool HasTrianglesAlone(vtkPolyData* mesh)
{
  return mesh && mesh->GetNumberOfVerts() == 0 && mesh->GetNumberOfLines() == 0;
}

// What of the renderer's picture is in the window, pixels.
void FindPart(vtkRenderer* renderer, int part[4], int size[2])
{
  renderer->GetTiledSizeAndOrigin(&part[2], &part[3], &part[0], &part[1]);
  size[0] = part[0] + part[2];
  size[1] = part[1] + part[3];
}
}

namespace wfv
{
bool MayShareEyes(vtkProp* prop)
{
  auto* const actor = vtkActor::SafeDownCast(prop);
  if (!actor || !DrawsAsStock(actor))
  {
    return false;
  }
  vtkProperty* const property = actor->GetProperty();
  auto* const mesh = vtkPolyData::SafeDownCast(actor->GetMapper()->GetInputDataObject(0, 0));
  return HasTrianglesAlone(mesh) && property->GetRepresentation() == VTK_SURFACE &&
    !property->GetEdgeVisibility() && !property->GetVertexVisibility();
}

bool EyesAtOnce::Drawn::operator==(const Drawn& o) const
{
  return this->Renderer == o.Renderer && this->Type == o.Type && this->View == o.View &&
    this->Time == o.Time && this->Props == o.Props;
}

void EyesAtOnce::Note(const Frame& frame, Drawn& drawn)
{
  drawn.Renderer = frame.Renderer;
  drawn.Type = frame.Renderer->GetRenderWindow()->GetStereoType();
  drawn.View = frame.View;
  drawn.Time = frame.Time;
  drawn.Props.clear();
  for (int i = 0; i < frame.Count; i++)
  {
    auto* const actor = vtkActor::SafeDownCast(frame.Props[i]);
    vtkDataObject* const data = actor->GetMapper()->GetInputDataObject(0, 0);
    drawn.Props.emplace_back(actor,
      std::max({ actor->GetMTime(), actor->GetMapper()->GetMTime(), data->GetMTime(),
        actor->GetShaderProperty()->GetMTime() }));
  }
}

EyesAtOnce::Role EyesAtOnce::Begin(const Frame& frame, bool allowed)
{
  auto* const window = vtkOpenGLRenderWindow::SafeDownCast(frame.Renderer->GetRenderWindow());
  const bool waits = this->Waiting.Renderer != nullptr;
  this->Waiting.Renderer = nullptr; // for one frame alone
  if (!allowed || !window || frame.Count == 0 || !DrawsBoth(window))
  {
    return Alone;
  }
  int part[4];
  int size[2];
  FindPart(frame.Renderer, part, size);
  if (frame.Eye < 0)
  {
    return this->Layers.Prepare(window, size) ? First : Alone;
  }
  Note(frame, this->Wanted);
  this->Waiting.Renderer = waits ? frame.Renderer : nullptr;
  const bool same = waits && this->Waiting == this->Wanted && this->Layers.Fit(window, size);
  this->Waiting.Renderer = nullptr;
  return same ? Second : Alone;
}

void EyesAtOnce::Draw(const Frame& frame, Role role)
{
  int part[4];
  int size[2];
  FindPart(frame.Renderer, part, size);
  if (role == First)
  {
    this->Layers.Begin(part);
    for (int i = 0; i < frame.Count; i++)
    {
      frame.Props[i]->RenderOpaqueGeometry(frame.Renderer);
    }
    this->Layers.End();
    Note(frame, this->Waiting);
  }
  this->Layers.Show(role == First ? 0 : 1, part);
}

void EyesAtOnce::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Waiting.Renderer = nullptr;
  this->Layers.ReleaseGraphicsResources(window);
}
}
