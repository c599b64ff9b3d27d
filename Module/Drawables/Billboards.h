// SPDX-License-Identifier: BSD-3-Clause
// Text that stands at a place of the scene and faces the viewer: vtkBillboardTextActor3D.
#ifndef WideFoVBillboards_h
#define WideFoVBillboards_h

#include "Drawables/Facing.h"
#include "vtkWideFoVAbi.h"

#include <functional>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkBillboardTextActor3D;
class vtkProp;
class vtkRenderer;
class vtkWideFoVCamera;
VTK_ABI_NAMESPACE_END

namespace wfv
{
// Such an actor asks the camera for a matrix to find out how large its text is. So each is drawn
// by a camera of its own, which shows the place of the text where the map does, at its depth, and
// all round it in the plane of the picture. Calls with that one in the place of the renderer's;
// not at all where the text's place is not in the picture. tile: of the picture, from NDC to NDC;
// up: where the text's top points.
void ShowBillboard(vtkBillboardTextActor3D* actor, vtkRenderer* renderer, vtkWideFoVCamera* camera,
  const float tile[4], LabelUp up, const std::function<void()>& draw);

// Those that stand in the scene themselves. They come last, for text is translucent.
class Billboards
{
public:
  void Clear() { this->Actors.clear(); }

  // False for any other prop.
  bool Take(vtkProp* prop);

  // Those that were taken, but for those whose place is not in the picture.
  void Draw(vtkRenderer* renderer, vtkWideFoVCamera* camera, const float tile[4], LabelUp up) const;

private:
  std::vector<vtkBillboardTextActor3D*> Actors; // of this frame
};
}

#endif
