// SPDX-License-Identifier: BSD-3-Clause
// Draws the copies that a vtkGlyph3DMapper makes by the classes that they have: those that are not
// seen not at all, those within the tolerance of their chords by the vertex stage alone, or cut
// into smaller triangles, the others by the stage of the prop.
#ifndef WideFoVGlyphDraw_h
#define WideFoVGlyphDraw_h

#include "Clusters/Classifier.h"
#include "Frame/BufferTexture.h"
#include "Frame/FrameStatistics.h"
#include "Frame/GlyphSource.h"
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
// What every copy has of its own, as VTK's buffers hold it.
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
  // Those that a program draws.
  struct Group
  {
    GlyphArrays Arrays;
    vtkNew<vtkOpenGLBufferObject> Matrices;
    vtkNew<vtkOpenGLBufferObject> Normals;
    vtkNew<vtkOpenGLBufferObject> Colors;
    BufferTexture Chords;        // of each edge of the source, where there are several
    vtkMTimeType ChordsTime = 0; // of the source that they are of
    vtkOpenGLHelper Helper;

    void Upload();
    void AddAttributes();
  };

  bool MayDraw(vtkActor* actor);
  void DrawGroup(int kind);
  void ActivateChords(Group& group, int chords);
  vtkWideFoVStage* StageOf(int kind) const;
  bool Classify();
  void Download();
  void ClassifyCopies(vtkPolyData* source);
  void Gather(vtkPolyData* source);

  vtkWeakPointer<vtkOpenGLGlyph3DHelper> Helper;
  vtkWeakPointer<vtkGlyph3DMapper> Mapper; // whose end is observed
  unsigned long Done = 0;                  // the observer

  // While it draws.
  vtkRenderer* Renderer = nullptr;
  vtkActor* Actor = nullptr;
  vtkWideFoVStage* Stage = nullptr;

  std::size_t Indices = 0; // that the helper was left without

  // What was classified last, and for what.
  GlyphArrays All;
  vtkMTimeType Time = 0; // of VTK's buffers
  GlyphSource Source;
  double ToMap[16] = { 0 };
  ClassifierView View;
  bool Known = false;
  std::vector<int> Classes; // kinds, or Classifier::Unseen
  FrameStatistics Found;

  // By the stage of the prop; and by so many chords of the longest edge.
  static constexpr int NumberOfKinds = 6;
  static constexpr int ChordsOfKinds[NumberOfKinds] = { Classifier::None, 1, 2, 4, 8, 16 };
  Group Groups[NumberOfKinds];
};

// Of all the mappers that a pass draws.
class GlyphDraws
{
public:
  // What the stage draws with this mapper, whose program is ready; nothing, but for glyphs.
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
