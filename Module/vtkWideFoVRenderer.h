// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkWideFoVRenderer
 * @brief   a renderer whose coordinates go through the wide view
 *
 * World to view and view to world ask the camera's forward and ray functions, so that
 * vtkCoordinate, pickers, labels and 2D annotation placed in the world land where the
 * picture shows them. New cameras are vtkWideFoVCamera, and a vtkWideFoVPass is set.
 * With any other active camera it is vtkOpenGLRenderer.
 */

#ifndef vtkWideFoVRenderer_h
#define vtkWideFoVRenderer_h

#include "vtkWideFoVAbi.h" // For VTK_ABI_NAMESPACE_BEGIN

#include "vtkOpenGLRenderer.h"
#include "vtkRenderingWideFoVModule.h" // For export macro

VTK_ABI_NAMESPACE_BEGIN
class vtkWideFoVCamera;

class VTKRENDERINGWIDEFOV_EXPORT vtkWideFoVRenderer : public vtkOpenGLRenderer
{
public:
  ///@{
  /**
   * Standard methods of a VTK class.
   */
  static vtkWideFoVRenderer* New();
  vtkTypeMacro(vtkWideFoVRenderer, vtkOpenGLRenderer);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  ///@}

  /**
   * A vtkWideFoVCamera.
   */
  VTK_NEWINSTANCE
  vtkCamera* MakeCamera() override;

  ///@{
  /**
   * Through the view where the active camera is wide: depth is 0 on the near and 1 on
   * the far clip sphere. In an off-axis perspective as the eye sees that was drawn last.
   */
  void WorldToView(double& x, double& y, double& z) override;
  void ViewToWorld(double& x, double& y, double& z) override;
  void PoseToView(double& x, double& y, double& z) override;
  void ViewToPose(double& x, double& y, double& z) override;
  ///@}
  using Superclass::ViewToWorld;
  using Superclass::WorldToView;

  /**
   * The ray through a display point (pixels): origin and unit direction, world
   * coordinates. False where the map has no direction.
   */
  bool DisplayToRay(double x, double y, double origin[3], double direction[3]);

  /**
   * Sets the clip spheres of a wide camera, the clipping range of any other, for these bounds
   * (xmin, xmax, .., zmax; world).
   */
  void ResetCameraClippingRange(const double bounds[6]) override;
  using Superclass::ResetCameraClippingRange;

protected:
  vtkWideFoVRenderer();
  ~vtkWideFoVRenderer() override = default;

  vtkWideFoVCamera* GetWideCamera();
  bool HasOffAxisEye(); // of a perspective, with a place of its own

private:
  vtkWideFoVRenderer(const vtkWideFoVRenderer&) = delete;
  void operator=(const vtkWideFoVRenderer&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
