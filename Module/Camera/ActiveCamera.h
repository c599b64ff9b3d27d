// SPDX-License-Identifier: BSD-3-Clause
// Another camera in the place of a renderer's, for as long as this lives.
#ifndef WideFoVActiveCamera_h
#define WideFoVActiveCamera_h

#include "vtkCamera.h"
#include "vtkRenderer.h"

namespace wfv
{
// A renderer that is told of another camera tells everybody else; this one is not told.
class ActiveCamera
{
public:
  ActiveCamera(vtkRenderer* renderer, vtkCamera* camera)
    : Renderer(renderer)
    , Before(Access::Of(renderer))
  {
    Access::Of(renderer) = camera;
  }
  ~ActiveCamera() { Access::Of(this->Renderer) = this->Before; }
  ActiveCamera(const ActiveCamera&) = delete;
  ActiveCamera& operator=(const ActiveCamera&) = delete;

private:
  class Access : public vtkRenderer
  {
  public:
    static vtkCamera*& Of(vtkRenderer* renderer) { return renderer->*(&Access::ActiveCamera); }
  };

  vtkRenderer* Renderer;
  vtkCamera* Before;
};
}

#endif
