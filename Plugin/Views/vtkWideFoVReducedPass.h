// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkWideFoVReducedPass
 * @brief   draws its delegate into the corner that IceT takes for a reduced frame
 *
 * For a frame with fewer pixels IceT leaves the window as it is, hands out a projection matrix that
 * shrinks the picture into the lower left corner, and composites that corner. A wide camera has
 * no use for a matrix, so here the corner is made the viewport.
 */
#ifndef vtkWideFoVReducedPass_h
#define vtkWideFoVReducedPass_h

#include "vtkRenderPass.h"
#include "vtkSmartPointer.h"

class vtkWideFoVReducedPass : public vtkRenderPass
{
public:
  static vtkWideFoVReducedPass* New();
  vtkTypeMacro(vtkWideFoVReducedPass, vtkRenderPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * What is drawn (default: nothing).
   */
  void SetDelegatePass(vtkRenderPass* pass) { this->Delegate = pass; }

  /**
   * How many times fewer pixels the corner has on each side than the window, 1 or more (default 1:
   * the delegate alone).
   */
  void SetFactor(int factor) { this->Factor = factor; }

  void Render(const vtkRenderState* s) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkWideFoVReducedPass() = default;
  ~vtkWideFoVReducedPass() override = default;

private:
  vtkWideFoVReducedPass(const vtkWideFoVReducedPass&) = delete;
  void operator=(const vtkWideFoVReducedPass&) = delete;

  void RenderDelegate(const vtkRenderState* s);

  vtkSmartPointer<vtkRenderPass> Delegate;
  int Factor = 1;
};

#endif
