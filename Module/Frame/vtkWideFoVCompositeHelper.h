// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkWideFoVCompositeHelper
 * @brief   draws the blocks of a vtkCompositePolyDataMapper2 by clusters
 *
 * A composite mapper hands its blocks to helpers, which are mappers of their own. This one draws
 * as the stock one does, but under a vtkWideFoVPass it classifies the clusters of each block as
 * vtkWideFoVPolyDataMapper does those of its mesh. Visibility, opacity, colours, picking and what
 * is selected stay the stock helper's work.
 */
#ifndef vtkWideFoVCompositeHelper_h
#define vtkWideFoVCompositeHelper_h

#include "Compat/Gl.h"
#include "vtkWideFoVAbi.h"

#include "vtkColor.h" // which VTK 9.1's header of the helper takes for granted
#include "vtkCompositeMapperHelper2.h"

#include <memory>

VTK_ABI_NAMESPACE_BEGIN
class vtkCompositeMapperHelperData;
class vtkWideFoVStage;
class vtkWindow;

class vtkWideFoVCompositeHelper : public vtkCompositeMapperHelper2
{
public:
  static vtkWideFoVCompositeHelper* New();
  vtkTypeMacro(vtkWideFoVCompositeHelper, vtkCompositeMapperHelper2);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkWideFoVCompositeHelper();
  ~vtkWideFoVCompositeHelper() override;

  void RenderPieceDraw(vtkRenderer* renderer, vtkActor* actor) override;
  void SetCustomUniforms(vtkOpenGLHelper& cellBO, vtkActor* actor) override;

private:
  vtkWideFoVCompositeHelper(const vtkWideFoVCompositeHelper&) = delete;
  void operator=(const vtkWideFoVCompositeHelper&) = delete;

  // Classifies the polygons or the strips of the blocks; false where none are drawn otherwise than
  // the stage says.
  bool Classify(int primitive, vtkActor* actor, vtkWideFoVStage* stage);

  // Draws them: every block's with one program before the next one.
  void DrawClusters(int primitive, vtkRenderer* renderer, vtkActor* actor, vtkWideFoVStage* stage);
  void DrawKind(int kind, int primitive, vtkActor* actor);

  // Whether a block is to be seen, or picked, in this traversal of the props.
  bool IsDrawn(const vtkCompositeMapperHelperData& block, vtkActor* actor) const;

  // What was classified for blocks that are gone.
  void Forget();

  struct Internals;
  std::unique_ptr<Internals> Internal;
};
VTK_ABI_NAMESPACE_END

#endif
