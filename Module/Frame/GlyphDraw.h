// SPDX-License-Identifier: BSD-3-Clause
// Draws the copies that a vtkGlyph3DMapper makes, refined for the view: copies that are fine by one
// instanced call, pieces of the other ones by another call, both with one program.
#ifndef WideFoVGlyphDraw_h
#define WideFoVGlyphDraw_h

#include "Frame/FrameStatistics.h"
#include "Frame/RefinedDraw.h"
#include "Refine/Clusters.h"
#include "Refine/Refiner.h"
#include "vtkWideFoVAbi.h"

#include "vtkNew.h"
#include "vtkOpenGLBufferObject.h"
#include "vtkOpenGLHelper.h"
#include "vtkWeakPointer.h"

#include <memory>
#include <unordered_map>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkAbstractMapper;
class vtkActor;
class vtkGlyph3DMapper;
class vtkOpenGLGlyph3DHelper;
class vtkPolyData;
class vtkProp;
class vtkRenderer;
class vtkWideFoVStage;
class vtkWindow;
VTK_ABI_NAMESPACE_END

namespace wfv
{
// Holds the arrays that have a value for each copy, as VTK's buffers have them.
struct GlyphArrays
{
  std::vector<float> Matrices;       // 16 each
  std::vector<float> Normals;        // 9 each, or none
  std::vector<unsigned char> Colors; // 4 each

  std::size_t Count() const { return this->Matrices.size() / 16; }
  void Clear();
  void Add(const GlyphArrays& from, std::size_t i);
};

// The copies of one source. VTK draws them by one call, of a function that cannot be overridden;
// this draws in its place once the program of its triangles is ready, and leaves it no index until
// the mapper is done.
class GlyphDraw
{
public:
  explicit GlyphDraw(vtkOpenGLGlyph3DHelper* helper);
  ~GlyphDraw();

  // When the helper has a program ready, with the stage.
  void Draw(vtkRenderer* renderer, vtkActor* actor, vtkWideFoVStage* stage);

  // When the mapper is done: it has its indices again.
  void Finish();
  void ReleaseGraphicsResources(vtkWindow* window);

  // nullptr once it has been deleted.
  vtkOpenGLGlyph3DHelper* GetHelper() const;

private:
  // The buffers of the values that every copy, or every vertex of a piece of a copy, has.
  struct ArrayBuffers
  {
    vtkNew<vtkOpenGLBufferObject> Matrices;
    vtkNew<vtkOpenGLBufferObject> Normals;
    vtkNew<vtkOpenGLBufferObject> Colors;
    bool HasNormals = false;

    void Upload(const GlyphArrays& arrays);
    void AddAttributes(
      vtkOpenGLVertexArrayObject* vao, vtkShaderProgram* program, int divisor) const;
    void ReleaseGraphicsResources();
  };

  // Lists the copies and pieces that one thread finds in a row of copies.
  struct Found
  {
    std::vector<std::size_t> Fine; // copies
    Pieces Refined;
    std::vector<std::size_t> Copies; // of each vertex of a piece
    vtkIdType CulledTriangles = 0;
  };

  bool MayDraw(vtkActor* actor);
  bool Prepare(); // false if the stage draws all copies as they are
  void Download();
  void Refine(vtkPolyData* source);
  void RefineCopy(const Refiner& refiner, vtkPolyData* source, std::size_t copy, EndCache& cache,
    Found& found) const;
  void RefineTriangles(const Refiner& refiner, vtkPolyData* source, const Affine& toMap,
    std::size_t copy, EndCache& cache, Found& found) const;
  void Gather(const std::vector<Found>& found);
  void SetOwnNumbers(vtkShaderProgram* program);
  bool MakeReady();
  void DrawFine();
  void DrawPieces();

  vtkWeakPointer<vtkOpenGLGlyph3DHelper> Helper;
  vtkWeakPointer<vtkGlyph3DMapper> Mapper; // whose end is observed
  unsigned long Done = 0;                  // the observer

  // While it draws.
  vtkRenderer* Renderer = nullptr;
  vtkActor* Actor = nullptr;
  vtkWideFoVStage* Stage = nullptr;

  std::size_t Indices = 0; // that the helper was left without

  // The last refinement, and the copies, the source and the view that it was made for.
  GlyphArrays All;
  vtkMTimeType Time = 0; // of VTK's buffers
  Clusters Source{ false };
  vtkMTimeType SourceTime = 0;
  double LongestEdge = 0; // of the source
  double ToMap[16] = { 0 };
  RefineView View;
  bool Known = false;
  FrameStatistics Counts;

  GlyphArrays Fine; // copies that are drawn as they are
  ArrayBuffers FineBuffers;
  vtkOpenGLHelper FineHelper;
  Pieces Refined; // of the other ones
  ArrayBuffers PieceArrays;
  PieceBuffers Buffers;
  NumberTable Numbers;
  RefinedDraw Whole{ 3 }; // gives programs the numbers of copies that are drawn as they are
};

// The GlyphDraw of each mapper that a pass draws.
class GlyphDraws
{
public:
  // Draws the copies if the mapper is one of glyphs and its program is ready.
  void Draw(
    vtkRenderer* renderer, vtkAbstractMapper* mapper, vtkProp* prop, vtkWideFoVStage* stage);

  // After the props have been drawn.
  void Finish();
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  std::unordered_map<vtkAbstractMapper*, std::unique_ptr<GlyphDraw>> Draws;
};
}

#endif
