// SPDX-License-Identifier: BSD-3-Clause
// What wfv::SortedDraw keeps of an actor.
#ifndef vtkWideFoVSortedEntry_h
#define vtkWideFoVSortedEntry_h

#include "vtkWideFoVBufferTexture.h"
#include "vtkWideFoVFrameCounts.h"
#include "vtkWideFoVSortedDraw.h"
#include "vtkWideFoVSorter.h"

#include "vtkActor.h"
#include "vtkNew.h"
#include "vtkOpenGLIndexBufferObject.h"
#include "vtkPolyData.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

namespace wfv
{
// What was sorted for one actor.
struct SortedDraw::Entry
{
  vtkWeakPointer<vtkActor> Actor;
  vtkPolyData* Data = nullptr;
  vtkMTimeType Time = 0;
  double ToMap[16] = { 0 };
  SortView View;
  int Frames = 0;   // drawn since, before this one
  int FirstEye = 0; // that was drawn in the first of them: the other belongs to the same frame
  int LastEye = 0;
  bool Haste = false;             // sorted so
  std::size_t All = 0;            // triangles of the mesh
  Sorter::Lot Lots[NumberOfLots]; // one follows the other
  FrameCounts Found;
  vtkIdType LeftOut[3] = { 0, 0, 0 }; // of triangles, by the left eye, both, the right one
  std::vector<unsigned int> Order;    // kept for programs that ask for numbers
  vtkNew<vtkOpenGLIndexBufferObject> Indices;
  std::vector<unsigned int> Reaches; // of the calm ones, until they are loaded
  std::vector<float> Pieces;         // with them, two places a piece: WFV_PIECE of their shader
  bool Cuts = false;                 // some triangles are drawn in pieces
  BufferTexture ReachTexture;
  BufferTexture PieceTexture;

  void CountFrame(bool still, int eye);
  void TakePieces(const std::vector<CoverPiece>& pieces);
  void Load(vtkOpenGLRenderWindow* window);

  std::size_t GetFirst(Lot lot) const
  {
    std::size_t first = 0;
    for (int i = 0; i < lot; i++)
    {
      first += this->Lots[i].All;
    }
    return first;
  }

  // What an eye draws of a lot, of all in their order: the first, and how many.
  std::pair<std::size_t, std::size_t> GetRun(Lot lot, int eye) const
  {
    const Sorter::Lot& all = this->Lots[lot];
    const std::size_t before = eye > 0 ? all.Left : 0;
    const std::size_t behind = eye < 0 ? all.Right : 0;
    return { this->GetFirst(lot) + before, all.All - before - behind };
  }

  // One lot has all of the mesh, once, for all eyes.
  bool IsWhole() const
  {
    const auto has = [this](const Sorter::Lot& lot) {
      return lot.All == this->All && lot.Left == 0 && lot.Right == 0;
    };
    return !this->Cuts && std::any_of(std::begin(this->Lots), std::end(this->Lots), has) &&
      this->All == this->GetFirst(NumberOfLots);
  }
};
}

#endif
