// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkWideFoVStatisticsActor
 * @brief   what a vtkWideFoVPass drew and left out, as text on the picture
 *
 * Add it to a renderer and give it the renderer's pass: it shows vtkWideFoVPass::GetStatistics of
 * the very frame that it is in (of two eyes, of each in its own), and how long the frame before
 * took. It is a vtkTextActor, in a fixed-width font at the upper left to begin with; a program that
 * uses it links VTK::RenderingFreeType, as for any text.
 */

#ifndef vtkWideFoVStatisticsActor_h
#define vtkWideFoVStatisticsActor_h

#include "vtkWideFoVAbi.h" // For VTK_ABI_NAMESPACE_BEGIN

#include "vtkRenderingWideFoVModule.h" // For export macro
#include "vtkTextActor.h"
#include "vtkWeakPointer.h" // For the pass

VTK_ABI_NAMESPACE_BEGIN
class vtkWideFoVPass;

class VTKRENDERINGWIDEFOV_EXPORT vtkWideFoVStatisticsActor : public vtkTextActor
{
public:
  ///@{
  /**
   * Standard methods of a VTK class.
   */
  static vtkWideFoVStatisticsActor* New();
  vtkTypeMacro(vtkWideFoVStatisticsActor, vtkTextActor);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  ///@}

  ///@{
  /**
   * The pass that it tells of; it is not kept alive. nullptr (the default): nothing is shown.
   */
  void SetPass(vtkWideFoVPass* pass);
  vtkWideFoVPass* GetPass();
  ///@}

  ///@{
  /**
   * What the renderer calls.
   */
  int RenderOpaqueGeometry(vtkViewport* viewport) override;
  int RenderOverlay(vtkViewport* viewport) override;
  ///@}

protected:
  vtkWideFoVStatisticsActor();
  ~vtkWideFoVStatisticsActor() override;

private:
  vtkWideFoVStatisticsActor(const vtkWideFoVStatisticsActor&) = delete;
  void operator=(const vtkWideFoVStatisticsActor&) = delete;

  vtkWeakPointer<vtkWideFoVPass> Pass;
};
VTK_ABI_NAMESPACE_END

#endif
