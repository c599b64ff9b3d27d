// SPDX-License-Identifier: BSD-3-Clause
// Which triangles of a mesh a view need not draw, and which of them the vertex stage alone.
#ifndef vtkWideFoVSorter_h
#define vtkWideFoVSorter_h

#include "vtkWideFoVAbi.h"
#include "vtkWideFoVClusters.h"
#include "vtkWideFoVEdgeDoubts.h"
#include "vtkWideFoVTriangleJudge.h"
#include "vtkWideFoVTrianglePieces.h"

#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkPoints;
VTK_ABI_NAMESPACE_END

namespace wfv
{
template <typename Real>
struct Scene;

// Every triangle is unseen (outside the picture, or between its samples), plain (its chords are
// near enough to its edges, it meets no discontinuity, and no hidden face shows beside it,
// vtkWideFoVEdgeDoubts.h) or has to be covered. Plain ones beside a covered one are drawn both ways
// where a sample is in doubt between the two: so none is left out.
class Sorter
{
public:
  // The triangles of the clusters, whose points these are; toMap: row-major matrix from their
  // coordinates to the map's own frame. Returns false where the kind of points is not known.
  bool Sort(Clusters& clusters, vtkPoints* points, const double toMap[16], const SortView& view);

  // The same in haste, for a view that may be gone with the next frame: no triangle is looked into
  // for samples, and plain ones are those whose chords are within view.Moving of their edges.
  bool SortInHaste(
    Clusters& clusters, vtkPoints* points, const double toMap[16], const SortView& view);

  // Of the triangles in their order some that are drawn alike. What one of two eyes alone needs
  // comes first or last, so that each draws one run.
  struct Lot
  {
    std::size_t All = 0;
    std::size_t Left = 0;  // the first ones, for the left eye alone
    std::size_t Right = 0; // the last ones, for the right eye alone

    // Once what stands behind others is known (wfv::SortedDraw): before all others those that no
    // eye sees; of the left eye's and the right eye's own ones the first and the last are hidden;
    // and where there are two eyes each has a list of what it sees of those for both, in between.
    std::size_t Hidden = 0;
    std::size_t LeftHidden = 0;
    std::size_t RightHidden = 0;
    std::size_t LeftSees = 0;
    std::size_t RightSees = 0;
    std::size_t Twice = 0; // how many are in both lists
  };

  // Numbers of triangles: those to be covered first, calm ones after the others, and with those
  // once a piece the ones that are covered in pieces; then the plain ones. A few are both.
  void TakeOrder(std::vector<unsigned int>& order) { this->Order.swap(order); }
  const Lot& GetCovered() const { return this->Covered; }
  const Lot& GetCalm() const { return this->Calm; }
  const Lot& GetPlain() const { return this->Plain; }

  // Of the calm triangles in their order: TriangleJudge::Verdict::Reach, or PieceBits and a number
  // of GetPieces.
  const std::vector<unsigned int>& GetReaches() const { return this->Reaches; }
  const std::vector<CoverPiece>& GetPieces() const { return this->Pieces; }
  static constexpr unsigned int PieceBits = 3u << 30;

  // Of all triangles in the mesh's order, bits of sorting::Fold; empty where nothing is known.
  void TakeFolds(std::vector<unsigned char>& folds) { this->Folds.swap(folds); }

  // Of clusters, those that nothing is drawn of.
  int GetNumberOfUnseen() const { return this->Unseen; }

  // Of triangles; eye: -1, 1, or 0 for all that are sorted for.
  vtkIdType GetNumberOfLeftOut(int eye) const
  {
    return this->LeftOut + (eye < 0 ? this->LeftOutLeft : eye > 0 ? this->LeftOutRight : 0);
  }

private:
  template <typename SortAll>
  bool SortWith(
    const Clusters& clusters, vtkPoints* points, const SortView& view, const SortAll& sort);
  template <typename Real>
  void SortPoints(
    Clusters& clusters, const Real* points, const double toMap[16], const SortView& view);
  template <typename Real>
  void SortPointsInHaste(
    Clusters& clusters, const Real* points, const double toMap[16], const SortView& view);
  void CoverBeside(Clusters& clusters);
  void Finish();
  void CoverTriangle(unsigned int triangle);
  template <typename Take>
  void VisitPlain(const EdgeDoubts::Lists& doubts, const Take& take) const;
  void SpreadCovered(const EdgeDoubts::Lists& doubts, const EdgeDoubts::Mesh& mesh);
  bool SpreadOverOutlines(const EdgeDoubts::Lists& doubts, const EdgeDoubts::Mesh& mesh);
  template <typename Real>
  void SettleDoubts(
    const Scene<Real>& scene, Clusters& clusters, std::vector<EdgeDoubts::Lists>& doubts);
  template <typename Real>
  void CutCovers(const Scene<Real>& scene);
  template <typename Real>
  void FindFolds(const Scene<Real>& scene, Clusters& clusters);
  Lot AppendLot(int mask, int wanted);
  std::size_t AppendKind(int mask, int wanted);
  std::size_t AppendPieces(int from, int to);
  void OrderReaches(std::size_t first, std::size_t left);
  void MakeOrder();

  std::vector<unsigned char> Kinds;  // one a triangle
  std::vector<unsigned char> Sides;  // one a triangle, while some may be plain
  std::vector<unsigned char> Folds;  // one a triangle, or none
  std::vector<unsigned int> Reaches; // one a triangle; once all is sorted, a calm one
  std::vector<CoverPiece> Pieces;    // by their triangles
  std::vector<unsigned int> Order;
  Lot Covered; // not calm
  Lot Calm;
  Lot Plain;
  int Eyes = 1;
  int Unseen = 0;
  vtkIdType LeftOut = 0;
  vtkIdType LeftOutLeft = 0; // for that eye, beside those
  vtkIdType LeftOutRight = 0;
};
}

#endif
