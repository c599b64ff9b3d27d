// SPDX-License-Identifier: BSD-3-Clause
// Passes over the whole picture, round the one that draws a wide view.
#ifndef WideFoVPassChain_h
#define WideFoVPassChain_h

#include "vtkWideFoVAbi.h"

#include "vtkSmartPointer.h"

#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkRenderPass;
class vtkWideFoVPass;
VTK_ABI_NAMESPACE_END

namespace wfv
{
// What of a pass, and of those that it calls, takes the picture for a perspective; nullptr where
// nothing does. It warns of it, once of each class.
vtkRenderPass* FindFlatPass(vtkRenderPass* pass);

// For a frame. Passes that change pixels draw by the wide pass instead of by what they have; it
// draws by that. Those that reckon in a perspective's depth are left out, with one warning each.
class PassChain
{
public:
  PassChain() = default;
  ~PassChain();
  PassChain(const PassChain&) = delete;
  PassChain& operator=(const PassChain&) = delete;

  // What draws the frame in the place of `outermost`. wide: where none is among them.
  vtkRenderPass* Begin(vtkRenderPass* outermost, vtkWideFoVPass* wide);

private:
  void Link(vtkRenderPass* outer, vtkRenderPass* inner);

  struct Change
  {
    vtkSmartPointer<vtkRenderPass> Pass;
    vtkSmartPointer<vtkRenderPass> Delegate; // that it had
  };
  std::vector<Change> Changes;
  vtkRenderPass* Outermost = nullptr;
  vtkSmartPointer<vtkWideFoVPass> Wide;
  vtkSmartPointer<vtkRenderPass> DelegateOfWide;
};
}

#endif
