// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkWideFoVPolyDataMapper
 * @brief   a polydata mapper that draws itself in the view of a vtkWideFoVCamera
 *
 * Once this library is loaded VTK makes one for whoever asks for a vtkPolyDataMapper.
 * Where there is no render pass it brings what vtkWideFoVPass adds to stock mappers. Under
 * a vtkWideFoVPass it leaves the work to the pass, but refines its triangles. With any other
 * camera, or with the projection "perspective", it is vtkOpenGLPolyDataMapper, to the pixel.
 */

#ifndef vtkWideFoVPolyDataMapper_h
#define vtkWideFoVPolyDataMapper_h

#include "vtkWideFoVAbi.h" // For VTK_ABI_NAMESPACE_BEGIN

#include "vtkOpenGLPolyDataMapper.h"
#include "vtkRenderingWideFoVModule.h" // For export macro

#include <memory> // For std::unique_ptr

VTK_ABI_NAMESPACE_BEGIN
class VTKRENDERINGWIDEFOV_EXPORT vtkWideFoVPolyDataMapper : public vtkOpenGLPolyDataMapper
{
public:
  ///@{
  /**
   * Standard methods of a VTK class.
   */
  static vtkWideFoVPolyDataMapper* New();
  vtkTypeMacro(vtkWideFoVPolyDataMapper, vtkOpenGLPolyDataMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  ///@}

  ///@{
  /**
   * As vtkWideFoVPass::SetTechnique (default vtkWideFoVPass::AUTO), SetTolerance
   * (default 0.25 pixels) and SetDebugView (default off).
   */
  virtual void SetTechnique(int technique);
  vtkGetMacro(Technique, int);
  vtkSetClampMacro(Tolerance, double, 0.001, 1e6);
  vtkGetMacro(Tolerance, double);
  vtkSetMacro(DebugView, vtkTypeBool);
  vtkGetMacro(DebugView, vtkTypeBool);
  vtkBooleanMacro(DebugView, vtkTypeBool);
  ///@}

  ///@{
  /**
   * What the actor calls.
   */
  void RenderPiece(vtkRenderer* renderer, vtkActor* actor) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  void RenderPieceDraw(vtkRenderer* renderer, vtkActor* actor) override;
  ///@}

protected:
  vtkWideFoVPolyDataMapper();
  ~vtkWideFoVPolyDataMapper() override;

  // The first call with a program that is ready.
  void SetCustomUniforms(vtkOpenGLHelper& cellBO, vtkActor* actor) override;

  int Technique = 0;
  double Tolerance = 0.25;
  vtkTypeBool DebugView = 0;

private:
  vtkWideFoVPolyDataMapper(const vtkWideFoVPolyDataMapper&) = delete;
  void operator=(const vtkWideFoVPolyDataMapper&) = delete;

  // Draws one kind of primitives refined. False if the superclass is to draw it.
  bool DrawRefined(int primitive, vtkRenderer* renderer, vtkActor* actor);

  struct Internals;
  std::unique_ptr<Internals> Internal;
};
VTK_ABI_NAMESPACE_END

#endif
