// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkWideFoVHardwareSelector
 * @brief   hardware selection in a window that shows two eyes
 *
 * vtkHardwareSelector draws what it selects as colours and reads them; a window in stereo mode
 * mixes those of both eyes. This one draws them for one eye alone, which the pointer is taken to
 * be seen by: the left one. With any other renderer and without stereo it is vtkHardwareSelector.
 */

#ifndef vtkWideFoVHardwareSelector_h
#define vtkWideFoVHardwareSelector_h

#include "vtkWideFoVAbi.h" // For VTK_ABI_NAMESPACE_BEGIN

#include "vtkOpenGLHardwareSelector.h"
#include "vtkRenderingWideFoVModule.h" // For export macro

VTK_ABI_NAMESPACE_BEGIN
class VTKRENDERINGWIDEFOV_EXPORT vtkWideFoVHardwareSelector : public vtkOpenGLHardwareSelector
{
public:
  ///@{
  /**
   * Standard methods of a VTK class.
   */
  static vtkWideFoVHardwareSelector* New();
  vtkTypeMacro(vtkWideFoVHardwareSelector, vtkOpenGLHardwareSelector);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  ///@}

  /**
   * Draws what is selected, for the left eye where the window is in stereo mode. False where that
   * fails, as of vtkHardwareSelector.
   */
  bool CaptureBuffers() override;

protected:
  vtkWideFoVHardwareSelector() = default;
  ~vtkWideFoVHardwareSelector() override = default;

private:
  vtkWideFoVHardwareSelector(const vtkWideFoVHardwareSelector&) = delete;
  void operator=(const vtkWideFoVHardwareSelector&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
