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
#include <cstdint>
#include <iterator>
#include <numeric>
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
  std::uint64_t HiddenIn = 0;     // scene in which hidden ones are
  bool Skips = false;             // those, in this frame
  std::size_t All = 0;            // triangles of the mesh
  Sorter::Lot Lots[NumberOfLots]; // one follows the other
  FrameCounts Found;
  vtkIdType LeftOut[3] = { 0, 0, 0 }; // of triangles, by the left eye, both, the right one
  std::vector<unsigned int> Order;    // kept for programs that ask for numbers
  vtkNew<vtkOpenGLIndexBufferObject> Indices;
  std::vector<unsigned int> Reaches; // of the calm ones
  bool Loaded = false;               // those and the pieces
  std::vector<float> Pieces;         // with them, two places a piece: WFV_PIECE of their shader
  std::vector<unsigned char> Folds;  // of all triangles in the mesh's order, or none
  bool FoldsLoaded = false;          // as the order is
  bool Cuts = false;                 // some triangles are drawn in pieces
  BufferTexture ReachTexture;
  BufferTexture PieceTexture;
  BufferTexture FoldTexture;

  void CountFrame(bool still, int eye);
  void TakePieces(const std::vector<CoverPiece>& pieces);
  void Load(vtkOpenGLRenderWindow* window);
  void LoadFolds(vtkOpenGLRenderWindow* window);

  // Gives one whose order is that of the mesh, which is not kept, a list of it; false where it has
  // one.
  bool TakeNaturalOrder();

  // Eyes that do not see a triangle, bits; of one picture alone both.
  enum Eyes : unsigned char
  {
    LeftEye = 1,
    RightEye = 2,
    NoEye = LeftEye | RightEye
  };

  // Of the triangles of a lot in their order, those that are hidden are put before all others.
  void HideInLot(Lot lot, const unsigned char* hidden);
  bool IsPiece(Lot lot, std::size_t place) const
  {
    return lot == Calm && this->Reaches[place] >= Sorter::PieceBits;
  }
  void ShowLot(Lot lot);                                         // as they were
  void Arrange(Lot lot, const std::vector<std::size_t>& places); // from which they come
  void MergeBoth(Lot lot, std::vector<std::size_t>& places) const;
  bool ComesBefore(Lot lot, std::size_t i, std::size_t j, bool piecesFirst) const;

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
  // Among hidden ones, if those are drawn, there are some of each eye: then all of the lot is.
  std::pair<std::size_t, std::size_t> GetRun(Lot lot, int eye) const
  {
    const Sorter::Lot& all = this->Lots[lot];
    if (!this->Skips && GetNumberOfHidden(all, 0) > 0)
    {
      return { this->GetFirst(lot), all.All };
    }
    const std::size_t before = all.Hidden +
      (eye > 0      ? all.Left + all.LeftSees
          : eye < 0 ? all.LeftHidden
                    : 0);
    const std::size_t behind = eye < 0 ? all.RightSees + all.Right : eye > 0 ? all.RightHidden : 0;
    return { this->GetFirst(lot) + before, all.All - before - behind };
  }

  // Those that an eye does not draw; 0: some eye.
  static std::size_t GetNumberOfHidden(const Sorter::Lot& lot, int eye)
  {
    const std::size_t left = lot.LeftHidden + lot.RightSees - lot.Twice;
    const std::size_t right = lot.RightHidden + lot.LeftSees - lot.Twice;
    return lot.Hidden + (eye <= 0 ? left : 0) + (eye >= 0 ? right : 0);
  }
  std::size_t GetNumberOfHidden(int eye) const
  {
    return std::accumulate(std::begin(this->Lots), std::end(this->Lots), std::size_t(0),
      [eye](std::size_t sum, const Sorter::Lot& lot) { return sum + GetNumberOfHidden(lot, eye); });
  }

  // For which eye alone the triangle at a place of the order is; 0: both, or without stereo.
  int GetEyeOf(std::size_t place) const
  {
    int lot = Covered;
    for (; place >= this->Lots[lot].All; lot++)
    {
      place -= this->Lots[lot].All;
    }
    const Sorter::Lot& all = this->Lots[lot];
    return place < all.Left ? -1 : place >= all.All - all.Right ? 1 : 0;
  }

  // One lot has all of the mesh, once, for all eyes.
  bool IsWhole() const
  {
    const auto has = [this](const Sorter::Lot& lot) {
      return lot.All == this->All && lot.Left == 0 && lot.Right == 0 &&
        GetNumberOfHidden(lot, 0) == 0;
    };
    return !this->Cuts && std::any_of(std::begin(this->Lots), std::end(this->Lots), has) &&
      this->All == this->GetFirst(NumberOfLots);
  }
};
}

#endif
