// SPDX-License-Identifier: BSD-3-Clause
#include "ViewMoves.h"

#include "vtkPVWideFoVView.h"

#include <pqUndoStack.h>
#include <pqView.h>

#include <vtkCamera.h>
#include <vtkCommand.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkSMPropertyHelper.h>
#include <vtkSMRenderViewProxy.h>
#include <vtkSMTrace.h>
#include <vtkSMViewLayoutProxy.h>

#include <array>
#include <string>

namespace wfvplugin
{
namespace
{
using Vector = std::array<double, 3>;

// Pixels of a panorama; ParaView shows it smaller where the window is.
constexpr std::array<int, 2> TwoToOne{ { 4096, 2048 } };

// A change of the camera, for ParaView's stack of cameras to go back to: it takes notice of what
// happens between these events.
void MoveCamera(
  pqView* view, vtkSMRenderViewProxy* proxy, Vector position, const Vector& ahead, const Vector& up)
{
  vtkRenderWindowInteractor* const hands = proxy->GetInteractor();
  hands->InvokeEvent(vtkCommand::StartInteractionEvent);
  vtkSMPropertyHelper(proxy, "CameraPosition").Set(position.data(), 3);
  const double distance = proxy->GetActiveCamera()->GetDistance();
  for (int i = 0; i < 3; ++i)
  {
    position[i] += distance * ahead[i];
  }
  vtkSMPropertyHelper(proxy, "CameraFocalPoint").Set(position.data(), 3);
  vtkSMPropertyHelper(proxy, "CameraViewUp").Set(up.data(), 3);
  proxy->UpdateVTKObjects();
  hands->InvokeEvent(vtkCommand::EndInteractionEvent);
  view->render();
}
}

vtkSMViewProxy* WideProxy(pqView* view)
{
  vtkSMViewProxy* proxy = view ? view->getViewProxy() : nullptr;
  return proxy && std::string(proxy->GetXMLName()) == "WideFoVView" ? proxy : nullptr;
}

void PutEyeIntoData(pqView* view)
{
  auto* const proxy = vtkSMRenderViewProxy::SafeDownCast(WideProxy(view));
  auto* const wide = vtkPVWideFoVView::SafeDownCast(proxy ? proxy->GetClientSideObject() : nullptr);
  Vector middle;
  if (!wide)
  {
    return;
  }
  proxy->Update();
  if (wide->GetMiddleOfData(middle.data()))
  {
    Vector ahead;
    Vector up;
    proxy->GetActiveCamera()->GetDirectionOfProjection(ahead.data());
    proxy->GetActiveCamera()->GetViewUp(up.data());
    MoveCamera(view, proxy, middle, ahead, up);
  }
}

void LookAlong(pqView* view, int axis, bool positive)
{
  if (auto* const proxy = vtkSMRenderViewProxy::SafeDownCast(WideProxy(view)))
  {
    Vector position;
    proxy->GetActiveCamera()->GetPosition(position.data());
    Vector ahead{ { 0, 0, 0 } };
    Vector up{ { 0, 0, 0 } };
    ahead[axis] = positive ? 1 : -1;
    up[axis == 2 ? 1 : 2] = 1;
    MoveCamera(view, proxy, position, ahead, up);
  }
}

void ToggleTwoToOne(pqView* view)
{
  vtkSMViewProxy* const proxy = WideProxy(view);
  vtkSMViewLayoutProxy* const layout = proxy ? vtkSMViewLayoutProxy::FindLayout(proxy) : nullptr;
  if (!layout)
  {
    return;
  }
  std::array<int, 2> size;
  vtkSMPropertyHelper shape(layout, "PreviewMode");
  shape.Get(size.data(), 2);
  size = size == TwoToOne ? std::array<int, 2>{ { 0, 0 } } : TwoToOne;
  BEGIN_UNDO_SET("2:1");
  {
    SM_SCOPED_TRACE(PropertiesModified).arg("proxy", layout);
    shape.Set(size.data(), 2);
    layout->UpdateVTKObjects();
  }
  END_UNDO_SET();
}
}
