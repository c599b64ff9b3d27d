// SPDX-License-Identifier: BSD-3-Clause
// Draws the polygons or the strips of a mapper in lots of triangles.
#ifndef vtkWideFoVSortedDraw_h
#define vtkWideFoVSortedDraw_h

#include "vtkWideFoVAbi.h"
#include "vtkWideFoVBufferTexture.h"
#include "vtkWideFoVSorter.h"

#include "vtkOpenGLHelper.h"
#include "vtkWeakPointer.h"

#include <map>
#include <memory>
#include <string>
#include <utility>

VTK_ABI_NAMESPACE_BEGIN
class vtkActor;
class vtkOpenGLIndexBufferObject;
class vtkOpenGLVertexBufferObjectGroup;
class vtkPoints;
class vtkPolyData;
class vtkWideFoVStages;
class vtkWideFoVStage;
VTK_ABI_NAMESPACE_END

namespace wfv
{
class DepthPicture;
class HiddenScene;
class SampleRays;

// Where a mesh lies in the buffers of its mapper.
struct DrawnPart
{
  unsigned int FirstVertex = 0;
  unsigned int Vertices = 0;
  std::size_t FirstIndex = 0; // in the mapper's own indices
  std::size_t Indices = 0;
};

class SortedDraw
{
public:
  // strips: draws the triangle strips of a mapper; else its polygons.
  explicit SortedDraw(bool strips);
  ~SortedDraw();

  // Whether there are so many cells that sorting them may be.
  static bool IsWorthIt(vtkPolyData* data, bool strips);
  static bool IsWorthIt(vtkPolyData* data) // of either
  {
    return IsWorthIt(data, false) || IsWorthIt(data, true);
  }

  // Sorts the triangles of `data` for this actor and frame where anything has changed: in haste,
  // and well once a view has been drawn so often that it pays. False where all of them are drawn as
  // the stage says, as usual. rounding: by how much the vertex buffer moves points at the most, in
  // their own units.
  bool Prepare(vtkPolyData* data, vtkActor* actor, vtkWideFoVStage* stage, double rounding);

  // Which triangles the next programs draw: those to be covered, those of them that are easy,
  // plain ones; All: every triangle, in the mapper's own order.
  enum Lot
  {
    Covered,
    Calm,
    Plain,
    NumberOfLots,
    All = NumberOfLots
  };
  void Choose(Lot lot) { this->Chosen = lot; }

  // Of what was prepared last, triangles.
  std::size_t GetNumberOf(Lot lot) const;

  // Draws the chosen ones, with the program that is bound. all: the mapper's own indices, which
  // serve where nothing is left out.
  void Draw(vtkOpenGLIndexBufferObject* all, const DrawnPart& part);

  // The numbers that the chosen lot's triangles have in the mapper.
  void SetParameters(vtkShaderProgram* program, vtkWindow* window);

  // After the mapper has drawn.
  void Finish();

  // The programs of a mapper for what does not have its own: calm and plain triangles.
  vtkOpenGLHelper& GetHelper(Lot lot) { return this->Helpers[lot]; }

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  struct Entry;

  bool PrepareEntry(
    Entry& entry, vtkPolyData* data, SortView& view, vtkWideFoVStages* stages, double rounding);
  void Sort(Entry& entry, vtkPolyData* data);
  void Take(Entry& entry); // what was sorted last
  void Upload(Entry& entry);
  void LoadNumbers(vtkOpenGLRenderWindow* window);
  void SetFolds(vtkShaderProgram* program, vtkOpenGLRenderWindow* window);

  // Leaves out what stands behind others, as soon as the scene says what does.
  void Hide(Entry& entry, vtkPolyData* data, vtkWideFoVStages* stages);
  bool FindHidden(Entry& entry, vtkPolyData* data, HiddenScene& scene);
  template <typename Real>
  void FindHiddenIn(const Entry& entry, const Real* points, const DepthPicture* const depths[],
    const SampleRays& rays, std::vector<unsigned char>& hidden);
  void PutBehind(Entry& entry, vtkPolyData* data, const std::vector<unsigned char>& hidden);
  void Show(Entry& entry, vtkPolyData* data);
  void Load(Entry& entry, vtkPolyData* data); // its triangles in another order

  const bool ForStrips;
  Clusters Mesh;
  Sorter Triangles;
  Entry* Find(vtkActor* actor);
  std::map<vtkActor*, std::unique_ptr<Entry>> Entries;
  Entry* Current = nullptr;
  bool Both = false; // eyes are drawn
  int Eye = 0;       // that is drawn, or 0: pieces of triangles may be for one alone
  Lot Chosen = All;
  bool Bound = false; // textures are, to units of theirs
  vtkOpenGLHelper Helpers[NumberOfLots];
  BufferTexture Numbers;
  Entry* NumbersOf = nullptr;
};

// By how much the vertex buffer moves these points at the most, in their own units; bounds: of all
// that are in the buffer.
double RoundingOf(
  vtkOpenGLVertexBufferObjectGroup* buffers, vtkPoints* points, const double bounds[6]);

// Makes the fragment stage of a mapper that draws so ask for those numbers.
void TakeSortedNumbers(std::string& fragment);
}

#endif
