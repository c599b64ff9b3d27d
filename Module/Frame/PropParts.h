// SPDX-License-Identifier: BSD-3-Clause
// Parts of props that are made of several: drawn as if each stood in the scene by itself.
#ifndef WideFoVPropParts_h
#define WideFoVPropParts_h

#include "Frame/PropKeys.h"
#include "vtkWideFoVAbi.h"

#include "vtkSmartPointer.h"

#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkProp;
class vtkWideFoVStage;
VTK_ABI_NAMESPACE_END

namespace wfv
{
class Stages;

// What a prop names as its parts: actors, volumes and images, but for itself; of a sky, the actor
// that draws it. Of what others keep to themselves see PartActor.h.
std::vector<vtkSmartPointer<vtkProp>> FindParts(vtkProp* prop);

class PropParts
{
public:
  // Gives the parts of a prop the stages that they need, where nobody has yet, and hides those that
  // cannot be drawn. Returns the parts. selects: props are picked.
  std::vector<vtkSmartPointer<vtkProp>> Attach(vtkProp* prop, Stages& stages, bool selects);

  // Of all.
  void Detach();

private:
  struct Part
  {
    vtkSmartPointer<vtkProp> Prop;
    vtkWideFoVStage* Stage;
    PropKeys Keys;
  };
  void Attach(vtkProp* part, vtkWideFoVStage* stage);
  void LeaveOut(vtkProp* part);
  void AttachSky(vtkProp* prop, Stages& stages);
  std::vector<Part> Parts;
  std::vector<vtkSmartPointer<vtkProp>> LeftOut;
};
}

#endif
