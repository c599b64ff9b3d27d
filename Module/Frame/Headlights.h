// SPDX-License-Identifier: BSD-3-Clause
// Headlights that shine from the eye, in pictures that stock VTK draws.
#ifndef WideFoVHeadlights_h
#define WideFoVHeadlights_h

#include "Compat/StockEdits.h"
#include "vtkWideFoVAbi.h"

#include "vtkOpenGLRenderPass.h"

#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkRenderer;
VTK_ABI_NAMESPACE_END

namespace wfv
{
// One bit a light that is on, in the renderer's order: the headlights without a position.
int FindHeadlights(vtkRenderer* renderer);
}

VTK_ABI_NAMESPACE_BEGIN
// Sits in the props' keys while they are drawn. Stock VTK takes a headlight for parallel to the
// view axis; on screens at angles to each other it would have a step where they meet. And it takes
// the rays of volumes from the camera's position, whichever eye is drawn.
class vtkWideFoVHeadlights : public vtkOpenGLRenderPass
{
public:
  static vtkWideFoVHeadlights* New();
  vtkTypeMacro(vtkWideFoVHeadlights, vtkOpenGLRenderPass);

  // Round the drawing of the props of a render state.
  void Begin(const vtkRenderState* s);
  void End(const vtkRenderState* s) { this->PostRender(s); }

  // Of a stock fragment stage whose tags are replaced.
  static void Rewrite(const wfv::stock::Traits& traits, std::string& fragment);

  bool PostReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool SetShaderParameters(vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop,
    vtkOpenGLVertexArrayObject* vao = nullptr) override;
  void Render(const vtkRenderState*) override {}

protected:
  // VTK's volume mappers ask the last pass of a prop how many buffers they draw to.
  vtkWideFoVHeadlights() { this->ActiveDrawBuffers = 1; }
  ~vtkWideFoVHeadlights() override = default;

private:
  vtkWideFoVHeadlights(const vtkWideFoVHeadlights&) = delete;
  void operator=(const vtkWideFoVHeadlights&) = delete;

  int Lights = 0;
  vtkRenderer* Renderer = nullptr; // valid between Begin and End
};
VTK_ABI_NAMESPACE_END

#endif
