// SPDX-License-Identifier: BSD-3-Clause
// Vertex buffers of refined triangles, laid out like the buffers of their mapper.
#ifndef WideFoVPieceBuffers_h
#define WideFoVPieceBuffers_h

#include "Frame/BufferTexture.h"
#include "Refine/Clusters.h"
#include "Refine/Refiner.h"
#include "vtkWideFoVAbi.h"

#include "vtkNew.h"
#include "vtkOpenGLBufferObject.h"
#include "vtkOpenGLIndexBufferObject.h"
#include "vtkOpenGLVertexArrayObject.h"

#include <functional>
#include <map>
#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLVertexBufferObject;
class vtkOpenGLVertexBufferObjectGroup;
VTK_ABI_NAMESPACE_END

namespace wfv
{
class PieceBuffers
{
public:
  // Fills the buffers unless they hold these pieces of these vertices already. corners: of the
  // mesh; firstVertex: of the mesh in the mapper's buffers. Returns false where the driver does not
  // let the mapper's buffers be read, with one warning: then there is nothing to draw.
  bool Load(const Pieces& pieces, const Corners& corners, vtkOpenGLVertexBufferObjectGroup* source,
    unsigned int firstVertex);

  // The numbers of the mapper's vertices, for a program that asks for them (vertex_number.glsl).
  static bool AsksForNumbers(vtkShaderProgram* program);
  void LoadNumbers(const Pieces& pieces, const Corners& corners, unsigned int firstVertex);

  // The pieces are other ones from now on.
  void Forget() { this->Loaded = this->Numbered = false; }

  // Draws the pieces with a program that is bound. mode: GL_TRIANGLES or GL_LINES. addOthers: adds
  // attributes that the mapper's buffers do not have. The caller binds its own vertex array again.
  using AddAttributes = std::function<void(vtkOpenGLVertexArrayObject*, vtkShaderProgram*)>;
  void Draw(vtkShaderProgram* program, unsigned int mode, const AddAttributes& addOthers = nullptr);

  void ReleaseGraphicsResources();

private:
  struct Attribute
  {
    vtkNew<vtkOpenGLBufferObject> Buffer;
    vtkMTimeType Time = 0; // of the mapper's buffer that it was made of
    unsigned int Stride = 0;
    int Type = 0;
    int Components = 0;
    bool Used = false; // the mapper has this attribute
  };

  bool LoadAttribute(Attribute& attribute, vtkOpenGLVertexBufferObject* source,
    const Pieces& pieces, const Corners& corners, unsigned int firstVertex);
  void LoadAsides(const Pieces& pieces);
  void AddAttributesTo(vtkShaderProgram* program);

  std::map<std::string, Attribute> Attributes;
  vtkNew<vtkOpenGLBufferObject> Asides;
  vtkNew<vtkOpenGLBufferObject> Numbers; // of vertices
  vtkNew<vtkOpenGLIndexBufferObject> Indices;
  vtkNew<vtkOpenGLVertexArrayObject> Array;
  unsigned int BoundProgram = 0; // that Array is for
  bool Loaded = false;
  bool Numbered = false;
};
}

#endif
