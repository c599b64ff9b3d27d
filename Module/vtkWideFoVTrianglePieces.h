// SPDX-License-Identifier: BSD-3-Clause
// Covers a triangle whose edges bend by many pixels with several shapes.
#ifndef vtkWideFoVTrianglePieces_h
#define vtkWideFoVTrianglePieces_h

#include "vtkWideFoVTriangleJudge.h"

#include <array>
#include <vector>

namespace wfv
{
// A rectangle of the picture, pixels from the middle of the framebuffer's viewport: its first
// corner, the side from there, and how high it is to the left of that.
struct CoverPiece
{
  unsigned int Triangle = 0;
  int Eye = 0; // that it is for: -1 the left, 1 the right one; 0: whichever is drawn
  vec2 From{ 0 };
  vec2 Side{ 0 };
  double Height = 0;
};

// What is within a closed curve of the picture is within the hull of the curve: so a triangle that
// nothing tears, and that holds no pole, is cut across its longest edge, and each slab is in the
// rectangle round its own boundary, which is looked at place by place.
class WFV_EXPORT TrianglePieces
{
public:
  // eye: one of the view's.
  explicit TrianglePieces(const SortView& view, int eye = 0);

  // Square pixels of a covering shape above which it is worth to look for several.
  static constexpr double LeastArea = 160;

  // Appends rectangles that together surely hold the picture of a triangle, and what float32 and
  // the vertex buffer may move of it. Returns false, and appends none, where a few such do not do,
  // or are larger together than `most`, square pixels. They overlap a little: what is opaque may be
  // drawn twice. Of one that a straight seam cuts those beside the picture are left out.
  bool Cover(unsigned int triangle, const TriangleJudge::Corner* const corners[3], double most,
    std::vector<CoverPiece>& pieces) const;

private:
  struct Boundary;
  struct Slab;

  bool IsWhole(const vec3 d[3]) const;
  double Measure(const vec3& from, const vec3& to) const;
  bool Look(const vec3& from, const vec3& to, Boundary& boundary) const;
  double GetTurn(const Slab& slab) const;
  bool IsWhole(const Slab& slab, bool& torn) const;
  double GetBeyond(const Boundary& boundary, const vec2& along) const;
  bool Enclose(const Slab& slab, double moved, CoverPiece& piece, bool& torn) const;
  void Append(CoverPiece piece, bool torn, std::vector<CoverPiece>& pieces) const;
  bool IsInPicture(const CoverPiece& piece) const;
  bool Cut(const std::array<vec3, 3>& d, int slabs, unsigned int triangle, double moved,
    double most, std::vector<CoverPiece>& pieces) const;

  // A place between two: a direction, or, seen by rays of its own, a point of the edge.
  vec3 Between(const vec3& a, const vec3& b, double t) const;
  vec2 PlaceOf(const vec3& place) const;
  vec3 DirectionOf(const vec3& place) const;

  vec2 Unroll(vec2 at, const vec2& beside) const;

  const SortView& V;
  TriangleJudge Judge;
  vec2 Middle;      // of the viewport
  int Eye = 0;      // CoverPiece
  double Pad;       // pixels
  double Round = 0; // pixels, of a turn about a map with a straight seam; 0: seams are left alone
};
}

#endif
