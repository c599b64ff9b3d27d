// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkWideFoVDataPass
 * @brief   renders what a picture is made of: colour, distance, cell, prop, normal
 *
 * Draws the props once, at pixel centres, into float buffers of the renderer's size,
 * with the delegate pass (a vtkWideFoVPass). Set it on the renderer, render, and read
 * GetOutput(). The window itself shows nothing of it.
 */

#ifndef vtkWideFoVDataPass_h
#define vtkWideFoVDataPass_h

#include "vtkWideFoVAbi.h" // For VTK_ABI_NAMESPACE_BEGIN

#include "vtkOpenGLRenderPass.h"
#include "vtkRenderingWideFoVModule.h" // For export macro

#include <memory> // For std::unique_ptr

VTK_ABI_NAMESPACE_BEGIN
class vtkImageData;

class VTKRENDERINGWIDEFOV_EXPORT vtkWideFoVDataPass : public vtkOpenGLRenderPass
{
public:
  ///@{
  /**
   * Standard methods of a VTK class.
   */
  static vtkWideFoVDataPass* New();
  vtkTypeMacro(vtkWideFoVDataPass, vtkOpenGLRenderPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;
  ///@}

  ///@{
  /**
   * The pass that draws; needed: without one, rendering is an error and draws nothing.
   */
  virtual void SetDelegatePass(vtkRenderPass* pass);
  vtkRenderPass* GetDelegatePass();
  ///@}

  /**
   * The number written to "prop" where this prop is seen is 1 + index. A prop without
   * an index writes 0 to "prop" and "cell", a negative index the same.
   */
  void SetPropIndex(vtkProp* prop, int index);

  /**
   * The last frame as an image of width x height points, rows from the bottom, float
   * point arrays: "color" (R G B A), "distance" (eye to surface along the ray, scene
   * units, +inf where nothing was hit), "cell" (0, or 1 + the id of the cell in the
   * polydata the mapper drew; exact to 2^24), "prop" (0, or 1 + index), "normal" (view
   * coordinates, unit length, towards the eye; 0 where nothing was hit).
   */
  vtkImageData* GetOutput();

  ///@{
  /**
   * What the renderer and the mappers call.
   */
  void Render(const vtkRenderState* s) override;
  bool PreReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool PostReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool SetShaderParameters(vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop,
    vtkOpenGLVertexArrayObject* vao = nullptr) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  ///@}

protected:
  vtkWideFoVDataPass();
  ~vtkWideFoVDataPass() override;

private:
  vtkWideFoVDataPass(const vtkWideFoVDataPass&) = delete;
  void operator=(const vtkWideFoVDataPass&) = delete;

  struct Internals;
  std::unique_ptr<Internals> Internal;
};
VTK_ABI_NAMESPACE_END

#endif
