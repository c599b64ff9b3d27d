// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkWideFoVCompositeHelper
 * @brief   draws the blocks of composite data, refined
 *
 * A composite mapper hands its blocks to mappers of its own. This one draws
 * as the stock one does, but under a vtkWideFoVPass it refines the triangles of each block as
 * vtkWideFoVPolyDataMapper refines its mesh. Visibility, opacity, colours, picking and what
 * is selected stay the stock helper's work.
 */
#ifndef vtkWideFoVCompositeHelper_h
#define vtkWideFoVCompositeHelper_h

#include "Compat/BlockMapper.h"
#include "Frame/RefinedDraw.h"
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

  // Draws one kind of primitives refined. False if the superclass is to draw it.
  bool DrawRefined(int primitive, vtkRenderer* renderer, vtkActor* actor, vtkWideFoVStage* stage);
  bool Refine(int primitive, bool lines, vtkActor* actor, vtkWideFoVStage* stage);
  void DrawBlocks(int primitive, bool lines, vtkRenderer* renderer, vtkActor* actor);
  wfv::DrawnPart PartOf(const BlockOfMapper& block, int primitive);

  // Whether a block is to be seen, or picked, in this traversal of the props.
  bool IsDrawn(const BlockOfMapper& block, vtkActor* actor) const;

  // Drops what was refined for blocks that are gone.
  void Forget();

  struct Internals;
  std::unique_ptr<Internals> Internal;
};
VTK_ABI_NAMESPACE_END

#endif
