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

#include "vtkNew.h" // For OwnPass
#include "vtkOpenGLRenderer.h"
#include "vtkRenderingWideFoVModule.h" // For export macro

#include <functional> // For std::function
#include <memory>     // For std::unique_ptr

namespace wfv
{
class AreaQuestions;
}

VTK_ABI_NAMESPACE_BEGIN
class vtkWideFoVCamera;
class vtkWideFoVPass;

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
   * the far clip sphere. In a perspective of two eyes as the eye sees that was drawn last.
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

  ///@{
  /**
   * A gradient background (GradientBackgroundOn) by direction instead of by the window's height
   * (default off): Background at the horizon and below it, Background2 straight up, evenly by
   * elevation between the two. Up is EnvironmentUp, a direction of the world, so that the horizon
   * stays where it is as the view turns. Outside the map is Background. Where the view is not
   * wide, and for a background with a texture, it changes nothing.
   */
  vtkSetMacro(GradientByDirection, bool);
  vtkGetMacro(GradientByDirection, bool);
  vtkBooleanMacro(GradientByDirection, bool);
  ///@}

  /**
   * Clears, and draws the background.
   */
  void Clear() override;

  ///@{
  /**
   * As vtkRenderer's: the bounds (xmin, xmax, .., zmax; world) are seen as a whole, from outside,
   * as by a perspective of the camera's view angle. Where the frame that is drawn next shows them
   * on less than a tenth of a wide picture, one warning says so.
   */
  void ResetCamera(const double bounds[6]) override;
  using Superclass::ResetCamera;
  ///@}

  /**
   * Puts the eye inside of what there is to see: into the middle of the visible props' bounds, or,
   * where a surface is near there, to the place in the middle half of the bounds that is farthest
   * from all surfaces. The direction of view and what is up stay. It does nothing where no prop has
   * bounds. Works with any camera.
   */
  void ResetCameraInside();

  /**
   * Sets the clip spheres of a wide camera, the clipping range of any other, for these bounds
   * (xmin, xmax, .., zmax; world).
   */
  void ResetCameraClippingRange(const double bounds[6]) override;
  using Superclass::ResetCameraClippingRange;

  /**
   * Draws a frame. Where the active camera is wide, its pass may be any: passes over the picture
   * (blur, tone mapping, supersampling, ..) draw the wide view, by the vtkWideFoVPass that is the
   * innermost of them or by this renderer's own. Those that take depths for those of a perspective
   * are left out with one warning. A pass of a class that VTK does not have is called as it is.
   */
  void DeviceRender() override;

  /**
   * Gives back what a window has of the passes that draw.
   */
  void ReleaseGraphicsResources(vtkWindow* window) override;

  /**
   * The wide camera of the frame that is drawn just now, else nullptr: passes over the picture put
   * a copy that is flat in its place.
   */
  vtkWideFoVCamera* GetFrameCamera() { return this->FrameCamera; }

#ifndef __VTK_WRAP__
  /// For vtkWideFoVPass: what draws the gradient by direction, as long as this lives.
  class BackgroundDrawer
  {
  public:
    /// draw: called instead of VTK's own gradient, of a vtkWideFoVRenderer.
    BackgroundDrawer(vtkRenderer* renderer, std::function<void()> draw);
    ~BackgroundDrawer();
    BackgroundDrawer(const BackgroundDrawer&) = delete;
    void operator=(const BackgroundDrawer&) = delete;

  private:
    vtkWideFoVRenderer* Renderer;
  };
#endif

protected:
  vtkWideFoVRenderer();
  ~vtkWideFoVRenderer() override;

  vtkWideFoVCamera* GetWideCamera();
  bool HasFlatEye();                                  // of a perspective, with a place of its own
  bool AnswerPicker(double& x, double& y, double& z); // if a picker asks; z: depth
  void WarnOfSmallness(vtkWideFoVCamera* camera);
  void WatchAreas(vtkWideFoVCamera* camera, double x, double y, double z); // z: depth
  void WarnOfArea();

  vtkWideFoVCamera* FrameCamera = nullptr;
  vtkNew<vtkWideFoVPass> OwnPass; // that it is made with
  bool GradientByDirection = false;

private:
  vtkWideFoVRenderer(const vtkWideFoVRenderer&) = delete;
  void operator=(const vtkWideFoVRenderer&) = delete;

  std::function<void()> DrawGradient;
  std::unique_ptr<wfv::AreaQuestions> Areas;

  // What ResetCamera was called for, and where it put the eye; not asked of a frame yet.
  struct Reset
  {
    double Bounds[6];
    double Position[3];
    bool Asked = true;
  };
  Reset LastReset;
};
VTK_ABI_NAMESPACE_END

#endif
