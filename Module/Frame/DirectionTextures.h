// SPDX-License-Identifier: BSD-3-Clause
// The tables of a direction map (wfv::DirectionMap) on the graphics card.
#ifndef WideFoVDirectionTextures_h
#define WideFoVDirectionTextures_h

#include "Projections/DirectionMap.h"
#include "vtkWideFoVAbi.h"

#include "vtkNew.h"
#include "vtkTextureObject.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkWindow;
VTK_ABI_NAMESPACE_END

namespace wfv
{
class DirectionTextures
{
public:
  // Uploads the tables, unless they are there already.
  void Load(const wfv::DirectionMap* map, vtkOpenGLRenderWindow* window);

  // Binds them for a program that names them; others cost a look-up.
  void Bind(vtkShaderProgram* program);

  // Gives the texture units back, at the end of a frame.
  void Unbind();

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  static void Upload(vtkTextureObject* texture, vtkOpenGLRenderWindow* window,
    const std::vector<wfv::DirectionMap::Texel>& table, int width, int height);

  unsigned long Serial = 0; // of the map that was uploaded
  vtkNew<vtkTextureObject> Directions;
  vtkNew<vtkTextureObject> Cells;
  vtkNew<vtkTextureObject> Seeds;
};
}

#endif
