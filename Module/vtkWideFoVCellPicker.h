// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkWideFoVCellPicker
 * @brief   a cell picker whose ray is that of the wide view
 *
 * vtkCellPicker builds its ray as if the picture were flat, which fails beside and
 * behind the eye. With a vtkWideFoVRenderer this one takes the ray of the view, in any
 * direction; with any other renderer it is vtkCellPicker.
 */

#ifndef vtkWideFoVCellPicker_h
#define vtkWideFoVCellPicker_h

#include "vtkWideFoVAbi.h" // For VTK_ABI_NAMESPACE_BEGIN

#include "vtkCellPicker.h"
#include "vtkRenderingWideFoVModule.h" // For export macro

VTK_ABI_NAMESPACE_BEGIN
class VTKRENDERINGWIDEFOV_EXPORT vtkWideFoVCellPicker : public vtkCellPicker
{
public:
  ///@{
  /**
   * Standard methods of a VTK class.
   */
  static vtkWideFoVCellPicker* New();
  vtkTypeMacro(vtkWideFoVCellPicker, vtkCellPicker);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  ///@}

  /**
   * Pick at a display point (pixels). Returns nonzero where something was hit between
   * the clip spheres.
   */
  int Pick(double x, double y, double z, vtkRenderer* renderer) override;
  using Superclass::Pick;

protected:
  vtkWideFoVCellPicker() = default;
  ~vtkWideFoVCellPicker() override = default;

private:
  vtkWideFoVCellPicker(const vtkWideFoVCellPicker&) = delete;
  void operator=(const vtkWideFoVCellPicker&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
