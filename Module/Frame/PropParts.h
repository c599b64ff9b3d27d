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

// What a prop names as its parts: actors, volumes and images, but for itself. Of what it keeps to
// itself see PartActor.h.
std::vector<vtkSmartPointer<vtkProp>> FindParts(vtkProp* prop);

class PropParts
{
public:
  // Gives the parts of a prop the stages that they need, where nobody has yet. Returns the parts.
  std::vector<vtkSmartPointer<vtkProp>> Attach(vtkProp* prop, Stages& stages);

  // Of all.
  void Detach();

private:
  struct Part
  {
    vtkSmartPointer<vtkProp> Prop;
    vtkWideFoVStage* Stage;
    PropKeys Keys;
  };
  std::vector<Part> Parts;
};
}

#endif
