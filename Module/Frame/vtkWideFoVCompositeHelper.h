// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkWideFoVCompositeHelper
 * @brief   draws the blocks of composite data by clusters
 *
 * A composite mapper hands its blocks to mappers of its own. This one draws
 * as the stock one does, but under a vtkWideFoVPass it classifies the clusters of each block as
 * vtkWideFoVPolyDataMapper does those of its mesh. Visibility, opacity, colours, picking and what
 * is selected stay the stock helper's work.
 */
#ifndef vtkWideFoVCompositeHelper_h
#define vtkWideFoVCompositeHelper_h

#include "Compat/BlockMapper.h"
#include "vtkWideFoVAbi.h"

#include <memory>

VTK_ABI_NAMESPACE_BEGIN
class vtkWideFoVStage;
class vtkWindow;

class vtkWideFoVCompositeHelper : public wfv::BlockMapper
{
public:
  static vtkWideFoVCompositeHelper* New();
  vtkTypeMacro(vtkWideFoVCompositeHelper, wfv::BlockMapper);
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
  bool IsDrawn(const BlockOfMapper& block, vtkActor* actor) const;

  // What was classified for blocks that are gone.
  void Forget();

  struct Internals;
  std::unique_ptr<Internals> Internal;
};
VTK_ABI_NAMESPACE_END

#endif
