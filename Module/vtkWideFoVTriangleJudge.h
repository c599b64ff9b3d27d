// SPDX-License-Identifier: BSD-3-Clause
// Whether the vertex stage alone may draw a triangle, seen from here.
#ifndef vtkWideFoVTriangleJudge_h
#define vtkWideFoVTriangleJudge_h

#include "Projections/LocalBend.h"
#include "Projections/Visibility.h"

#include <memory>

namespace wfv
{
// What a frame is drawn with, for the sorting of triangles.
struct SortView
{
  const Projection* Map = nullptr;
  WfvView View;
  Window Part;                            // of the picture
  vec2 Pixels{ 1 };                       // of the whole picture
  std::shared_ptr<const LocalBend> Bends; // none: triangles are not told apart
  bool Culls = true;                      // leaves out what is not seen

  // Two are the same where they sort alike; the time that it took to make them apart.
  bool operator==(const SortView& other) const;
};

// Decides on single triangles. The corners are in the map's own frame.
class TriangleJudge
{
public:
  // Pixels: how far a chord of a plain triangle may be from its edge. As much as `exact` may err;
  // a rasterizer snaps the ends of chords by up to 1/128 of a pixel as well.
  static constexpr double PlainError = 0.02;

  // The view outlives the judge, and has bends.
  explicit TriangleJudge(const SortView& view);

  // True where the triangle meets no discontinuity, lies between the clip spheres, and has chords
  // within PlainError of its edges.
  bool IsPlain(const vec3 q[3]) const;

  // -1, 1: which side is seen. 0: nearly edge-on.
  static int GetSide(const vec3 q[3]);

private:
  double GetBound2(const vec3 d[3], double angle2) const;
  bool MeasuresFine(const vec3 d[3], double angle2) const;

  const SortView& V;
  double Near;
  double Far;
  vec2 Scale;
};
}

#endif
