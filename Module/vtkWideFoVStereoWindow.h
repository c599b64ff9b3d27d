// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkWideFoVStereoWindow
 * @brief   the frame through which a stereo picture is seen: a floating window, a letterbox
 *
 * What stands in front of the screen and is cut by its border looks wrong, for the border is
 * behind it. A floating window brings the border forward: a bar covers the left side of the left
 * eye's picture and the right side of the right eye's, and the window is seen where things of the
 * parallax minus its width are. A letterbox covers the upper and the lower border of both
 * pictures. Add it to the renderer with AddViewProp; without stereo it shows the letterbox alone.
 */

#ifndef vtkWideFoVStereoWindow_h
#define vtkWideFoVStereoWindow_h

#include "vtkWideFoVAbi.h" // For VTK_ABI_NAMESPACE_BEGIN

#include "vtkActor2D.h"
#include "vtkNew.h"                    // For vtkNew
#include "vtkRenderingWideFoVModule.h" // For export macro

VTK_ABI_NAMESPACE_BEGIN
class vtkPoints;

class VTKRENDERINGWIDEFOV_EXPORT vtkWideFoVStereoWindow : public vtkActor2D
{
public:
  ///@{
  /**
   * Standard methods of a VTK class.
   */
  static vtkWideFoVStereoWindow* New();
  vtkTypeMacro(vtkWideFoVStereoWindow, vtkActor2D);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  ///@}

  ///@{
  /**
   * Width of the floating window's bars, fraction of the picture's width (default 0, clamped to
   * [0, 0.25]): how far the window comes forward, as a parallax.
   */
  vtkSetClampMacro(Floating, double, 0.0, 0.25);
  vtkGetMacro(Floating, double);
  ///@}

  ///@{
  /**
   * Height of each bar of the letterbox, fraction of the picture's height (default 0, clamped to
   * [0, 0.4]).
   */
  vtkSetClampMacro(Letterbox, double, 0.0, 0.4);
  vtkGetMacro(Letterbox, double);
  ///@}

  /// What the renderer calls: draws the bars of the present eye. 1 where it drew any.
  int RenderOverlay(vtkViewport* viewport) override;

protected:
  vtkWideFoVStereoWindow();
  ~vtkWideFoVStereoWindow() override;

private:
  vtkWideFoVStereoWindow(const vtkWideFoVStereoWindow&) = delete;
  void operator=(const vtkWideFoVStereoWindow&) = delete;

  // eye: -1, 0, 1
  void PlaceBars(int eye);

  double Floating = 0;
  double Letterbox = 0;
  vtkNew<vtkPoints> Corners; // four a bar
};
VTK_ABI_NAMESPACE_END

#endif
