// SPDX-License-Identifier: BSD-3-Clause
// A stage in a prop's list of passes for as long as the prop is drawn.
#ifndef WideFoVPropKeys_h
#define WideFoVPropKeys_h

#include "vtkWideFoVAbi.h"

#include "vtkInformation.h"
#include "vtkSmartPointer.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkProp;
class vtkWideFoVStage;
VTK_ABI_NAMESPACE_END

namespace wfv
{
// The passes that a prop's keys name, but for the stages of wide frames, in the place of those that
// `to` names. from may be nullptr.
void HandPassesOn(vtkInformation* from, vtkInformation* to);

// One for each prop of a frame, kept from frame to frame.
class PropKeys
{
public:
  // Appends the stage to the prop's list. What is drawn over the picture has no use for one.
  void Attach(vtkProp* prop, vtkWideFoVStage* stage);

  // Leaves the prop as it was: without a list, or without keys, where it had none.
  void Detach(vtkProp* prop, vtkWideFoVStage* stage);

private:
  // What an actor without keys is lent. To make a list anew for each of many props and frames would
  // take its time, and so would an actor that says it was modified.
  vtkSmartPointer<vtkInformation> Lent;
  vtkSmartPointer<vtkInformation> OfProp; // the reference that the prop then counts as its own
  bool Lends = false;
};
}

#endif
