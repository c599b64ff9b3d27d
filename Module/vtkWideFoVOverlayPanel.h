// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkWideFoVOverlayPanel
 * @brief   a text, a scalar bar or another overlay that stands in a direction
 *
 * An overlay lies in the plane of the picture and is bent where that is put on a dome. On this
 * panel, which faces the eye, it has its own shape for who looks there, and two eyes see it at the
 * depth of the panel:
 *
 * @code
 * panel->SetDirection(30, 20);
 * panel->SetDepth(5);
 * panel->SetOverlay(scalarBar, 600, 160);
 * panel->Follow(renderer);
 * renderer->AddViewProp(panel);
 * @endcode
 */

#ifndef vtkWideFoVOverlayPanel_h
#define vtkWideFoVOverlayPanel_h

#include "vtkWideFoVAbi.h" // For VTK_ABI_NAMESPACE_BEGIN

#include "vtkNew.h" // For the axes
#include "vtkOpenGLActor.h"
#include "vtkRenderingWideFoVModule.h" // For export macro
#include "vtkWeakPointer.h"            // For the renderer

VTK_ABI_NAMESPACE_BEGIN
class vtkMatrix4x4;
class vtkRenderer;

class VTKRENDERINGWIDEFOV_EXPORT vtkWideFoVOverlayPanel : public vtkOpenGLActor
{
public:
  ///@{
  /**
   * Standard methods of a VTK class.
   */
  static vtkWideFoVOverlayPanel* New();
  vtkTypeMacro(vtkWideFoVOverlayPanel, vtkOpenGLActor);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  ///@}

  ///@{
  /**
   * Where the middle of the panel is: degrees to the right of where the camera looks, and above the
   * horizon of its view up, -90 to 90 (0, 0). Anything else is an error, and changes nothing.
   */
  void SetDirection(double azimuth, double elevation);
  vtkGetMacro(Azimuth, double);
  vtkGetMacro(Elevation, double);
  ///@}

  ///@{
  /**
   * How wide the panel is, degrees between 0 and 180 (30). Anything else is an error, and changes
   * nothing.
   */
  void SetAngle(double degrees);
  vtkGetMacro(Angle, double);
  ///@}

  ///@{
  /**
   * How far the middle of the panel is from the eye, scene units above 0 (1): what is nearer hides
   * it. Anything else is an error, and changes nothing.
   */
  void SetDepth(double depth);
  vtkGetMacro(Depth, double);
  ///@}

  /**
   * Shows the overlay as it is now, in a window of so many pixels: its own coordinates are those of
   * that window. Draws in a window of its own, so call it between frames, with a display. False,
   * and an error, where there is no overlay or a side is below one pixel.
   */
  bool SetOverlay(vtkProp* overlay, int width, int height);

  /**
   * Turns with the renderer's active camera, whichever that is when a frame begins; with none
   * (nullptr, the default) it stays where it is. The renderer is not kept alive.
   */
  void Follow(vtkRenderer* renderer);

protected:
  vtkWideFoVOverlayPanel();
  ~vtkWideFoVOverlayPanel() override;

private:
  vtkWideFoVOverlayPanel(const vtkWideFoVOverlayPanel&) = delete;
  void operator=(const vtkWideFoVOverlayPanel&) = delete;

  void Place();
  void Turn();

  double Azimuth = 0;
  double Elevation = 0;
  double Angle = 30;
  double Depth = 1;
  int Pixels[2] = { 1, 1 };
  vtkNew<vtkMatrix4x4> Axes; // of the camera, in the world
  vtkWeakPointer<vtkRenderer> Followed;
  unsigned long Observer = 0;
};
VTK_ABI_NAMESPACE_END

#endif
