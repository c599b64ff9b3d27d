// SPDX-License-Identifier: BSD-3-Clause
// Draws the triangles of a mapper in two lots: those to be covered, and the plain ones.
#ifndef vtkWideFoVSortedDraw_h
#define vtkWideFoVSortedDraw_h

#include "vtkWideFoVSorter.h"

#include "vtkNew.h"
#include "vtkOpenGLHelper.h"
#include "vtkWeakPointer.h"

#include <map>
#include <memory>
#include <string>

class vtkActor;
class vtkOpenGLBufferObject;
class vtkOpenGLIndexBufferObject;
class vtkOpenGLRenderWindow;
class vtkPolyData;
class vtkShaderProgram;
class vtkTextureObject;
class vtkWideFoVStages;
class vtkWideFoVStage;
class vtkWindow;

namespace wfv
{
class SortedDraw
{
public:
  SortedDraw();
  ~SortedDraw();

  // Sorts the triangles of `data` for this actor and frame where anything has changed. False
  // where all of them are drawn as the stage says, as usual.
  bool Prepare(vtkPolyData* data, vtkActor* actor, vtkWideFoVStage* stage);

  // Of what was prepared last, triangles.
  std::size_t GetNumberOfCovered() const;
  std::size_t GetNumberOfPlain() const;

  // Which of them the next programs draw; All: every triangle, in the mapper's own order.
  enum class Lot
  {
    All,
    Covered,
    Plain
  };
  void Choose(Lot lot) { this->Chosen = lot; }

  // Draws the chosen ones, with the program that is bound. all: the mapper's own indices, which
  // serve where nothing is left out.
  void Draw(vtkOpenGLIndexBufferObject* all, unsigned int vertices);

  // The numbers that the chosen lot's triangles have in the mapper.
  void SetParameters(vtkShaderProgram* program, vtkWindow* window);

  // After the mapper has drawn.
  void Finish();

  // The second program of a mapper, for plain triangles among covered ones.
  vtkOpenGLHelper& GetPlainHelper() { return this->PlainHelper; }

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  struct Entry;

  void Sort(Entry& entry, vtkPolyData* data, const double toMap[16], const SortView& view);
  void LoadNumbers(vtkOpenGLRenderWindow* window);

  Clusters Mesh;
  Sorter Triangles;
  std::map<vtkActor*, std::unique_ptr<Entry>> Entries;
  Entry* Current = nullptr;
  Lot Chosen = Lot::All;
  vtkOpenGLHelper PlainHelper;
  vtkNew<vtkOpenGLBufferObject> NumberBuffer;
  vtkNew<vtkTextureObject> Numbers;
  Entry* NumbersOf = nullptr;
};

// Makes the fragment stage of a mapper that draws so ask for those numbers.
void TakeSortedNumbers(std::string& fragment);
}

#endif
