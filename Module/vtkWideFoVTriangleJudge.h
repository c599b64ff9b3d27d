// SPDX-License-Identifier: BSD-3-Clause
// Whether a triangle need be drawn, seen from here, and whether the vertex stage alone may do it.
#ifndef vtkWideFoVTriangleJudge_h
#define vtkWideFoVTriangleJudge_h

#include "vtkWideFoVSampleGrid.h"

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
  std::shared_ptr<const LocalBend> Bends; // none: all triangles are alike
  bool Plain = false;                     // some may be drawn by the vertex stage alone
  bool Calm = false;                      // those that are easy to cover are told apart
  bool Culls = true;                      // leaves out what is not seen
  double Rounding = 0;                    // by which the vertex buffer moves points, scene units
  SampleGrid Samples;
  double Reach = 0;                 // of two eyes from the origin
  const StereoModel* Own = nullptr; // of an eye whose rays begin in several places; else none

  // Two are the same where they sort alike; the time that it took to make them apart.
  bool operator==(const SortView& other) const;
};

// Decides on single triangles.
class TriangleJudge
{
public:
  // Pixels: how far a chord of a plain triangle may be from its edge. As much as `exact` may err;
  // a rasterizer snaps the ends of chords by up to 1/128 of a pixel as well.
  static constexpr double PlainError = 0.02;

  // The view outlives the judge, and has bends.
  explicit TriangleJudge(const SortView& view);

  // A point, in the map's own frame, as the view shows it.
  struct Corner
  {
    vec3 Place;
    vec3 Direction;  // in which it is seen, unit length
    double Distance; // along its ray
    vec2 At;         // pixels of the framebuffer
  };
  Corner See(const vec3& place) const;

  // Pixels: how far a chord of a calm triangle may be from its edge.
  static constexpr double CalmError = 0.25;

  struct Verdict
  {
    bool Empty = false; // surely covers no sample, drawn in whatever way
    bool Plain = false; // no discontinuity, between the clip spheres, chords within PlainError
    bool Calm = false;  // small, no discontinuity, chords within CalmError
    double Bend = 0;    // of a calm one, pixels that its chords may be off, over its angle squared
  };
  Verdict Judge(const Corner* const corners[3]) const;

  // -1, 1: which side is seen. 0: nearly edge-on.
  int GetSide(const Corner* const corners[3]) const;

private:
  // Of the map beside the corners of a triangle.
  struct Local
  {
    double Bound2;  // of the distance of chords from edges, pixels squared
    double Stretch; // pixels a radian
  };
  Local LookAt(const vec3 d[3], double angle2, double aside) const;

  // Of a triangle seen by rays of its own, radians: how far its edges may be off the great circles
  // between its corners. Infinite as near to the circle where rays begin as it is wide.
  double GetAside(const Corner* const c[3]) const;
  bool IsEmpty(const Corner* const c[3], double nearest, const Local& local) const;
  bool MeasuresFine(const Corner* const c[3], double angle2) const;

  const SortView& V;
  double Near;
  double Far;
  vec2 Scale;
  double Pad;        // pixels, round what is drawn
  double Circle = 0; // radius of that on which rays begin, scene units
};
}

#endif
