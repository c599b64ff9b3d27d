// SPDX-License-Identifier: BSD-3-Clause
// Whether a triangle need be drawn, seen from here, and whether the vertex stage alone may do it.
#ifndef vtkWideFoVTriangleJudge_h
#define vtkWideFoVTriangleJudge_h

#include "vtkWideFoVSampleGrid.h"

#include "Projections/LocalBend.h"
#include "Projections/Visibility.h"

#include <algorithm>
#include <memory>

namespace wfv
{
inline double Square(double x)
{
  return x * x;
}

// What a frame is drawn with, for the sorting of triangles.
struct SortView
{
  // Pixels: how far a chord of a plain triangle may be from its edge. As much as `exact` may err.
  static constexpr double PlainError = 0.02;

  const Projection* Map = nullptr;
  WfvView View;
  Window Part;                            // of the picture
  vec2 Pixels{ 1 };                       // of the whole picture
  std::shared_ptr<const LocalBend> Bends; // none: all triangles are alike
  bool Plain = false;                     // some may be drawn by the vertex stage alone
  bool Calm = false;                      // those that are easy to cover are told apart
  bool Rays = false;                      // all that is covered is drawn by the rays of pixels
  bool Folds = false;                     // of covered ones is known where the mesh folds
  bool Measures = true;                   // edges of which the bends say too little
  bool Cheap = false;                     // none is covered: to draw what is empty costs little
  bool Culls = true;                      // leaves out what is not seen
  double Rounding = 0;                    // by which the vertex buffer moves points, scene units
  SampleGrid Samples;
  double Reach = 0;                 // of two eyes from the origin
  double Tolerance = 0.25;          // pixels
  double Moving = 0;                // pixels: how far chords may be from their edges in haste
  const StereoModel* Own = nullptr; // of an eye whose rays begin in several places; else none

  // Eyes that a triangle is sorted for at once: of an eye whose rays begin in several places, the
  // other one as well, which sees by the same numbers but for the sign of View.stereo.x. What is
  // kept serves whichever of them is drawn, and both together.
  static constexpr int MostEyes = 2;
  int GetNumberOfEyes() const { return this->Own && this->View.stereo.x != 0 ? MostEyes : 1; }

  // As one of them sees.
  WfvView GetViewOf(int eye) const
  {
    WfvView view = this->View;
    view.stereo.x *= eye == 0 ? 1 : -1;
    return view;
  }

  // True where nothing moved: another part of the picture at the most, or another tolerance.
  bool IsSamePlace(const SortView& other) const;

  // Two are the same where they sort alike; the time that it took to make them apart.
  bool operator==(const SortView& other) const;
};

// Decides on single triangles.
class WFV_EXPORT TriangleJudge
{
public:
  // The view outlives the judge, and has bends; eye: one of its.
  explicit TriangleJudge(const SortView& view, int eye = 0);

  // A point, in the map's own frame, as the view shows it.
  struct Corner
  {
    vec3 Place;
    vec3 Direction;  // in which it is seen, unit length
    double Distance; // along its ray
    vec2 At;         // pixels of the framebuffer
  };
  Corner See(const vec3& place) const;

  // Radians: beyond that places along a chord, and what is interpolated there, are not those of its
  // edge.
  static constexpr double LongestPlain = 0.1;

  // Pixels: how far a chord of a calm triangle may be from its edge.
  static constexpr double CalmError = 15;

  // In a pixel, what says how far a side is moved out: WFV_REACHES of calm_triangles.glsl; so many
  // bits a side.
  static constexpr double Reaches = 64;
  static constexpr unsigned int ReachBits = 10;

  // Pixels: chords that are farther from their edges are not looked at for samples; radians: edges
  // that are longer are cut, as long as they are longer than this.
  static constexpr double MostKnown = 0.25;
  static constexpr double LongestPiece = 0.1;
  static constexpr double ShortestPiece = 1e-3;

  struct Verdict
  {
    bool Empty = false;     // surely covers no sample, drawn in whatever way
    bool Plain = false;     // no discontinuity, between the clip spheres, chords within PlainError
    bool Calm = false;      // small, no discontinuity, chords within CalmError
    unsigned int Reach = 0; // of a calm one: how far the sides of its chords are to be moved out to
                            // hold it, ReachBits for the one opposite to each corner
    bool Known = false;     // Widths are known: the edges are chords, more or less
    double Sure = 0;        // pixels, by which a rasterizer and float32 move chords
    double Widths[3] = { 0, 0,
      0 }; // pixels, of the edge from each corner: samples so near its chord may lie
           // on the other side of the edge, or of the chord as it is drawn
  };
  Verdict Judge(const Corner* const corners[3]) const;

  // Of a triangle that is calm for two eyes, what holds it for both.
  static unsigned int JoinReaches(unsigned int a, unsigned int b);

  // Square pixels of the shape that covers a calm triangle (preclip_narrow.glsl).
  static double GetCalmArea(const Corner* const corners[3], unsigned int reach);

  // Calls visit(from, to, width, sure) for the pieces of an edge of which is not known how far it
  // is off its chord: places in pixels, between which samples so near are in doubt, pixels; Sure of
  // the verdict. What is torn, or runs to where the map stretches without bound, is left out.
  template <typename Visit>
  void ForEachPiece(const Corner& from, const Corner& to, const Visit& visit) const;

  // On the distance of an edge from its chord, at its quarters or eighths, for what lies between.
  static constexpr double BetweenParts = 1.2;

  // Radians: edges that their quarters say enough of; the eighths of those that are twice as long.
  static constexpr double LongestMeasured = 0.25;

  // Over the distance from a singular point: edges that their quarters say enough of.
  static constexpr double PartOfSine = 0.25;

  // True where a triangle, whose corners these are, may meet a tear of the map, its edges so far
  // off their great circles, radians. Poles and antipodes are another matter.
  static bool MayTear(Family family, const vec3 d[3], double aside);

  // True where all of a triangle, whose corners are so far away and whose edges have such an angle,
  // squared, is between the clip spheres: it may come nearer than its corners, by an eighth of
  // that.
  static bool IsBetweenSpheres(const WfvView& view, double nearest, double farthest, double angle2);

  // True where no part of a triangle is beyond the rim of a round map, which may fold there.
  static bool IsInDomain(const SortView& view, const vec3 d[3]);

  // Pixels by which a rasterizer and float32 may move what is drawn in a picture so large.
  static double GetPad(const vec2& pixels);

  // Pixels by which the vertex buffer may move a corner, where the map stretches so much (pixels a
  // radian).
  double GetMoved(double nearest, double stretch) const;

  // The longest edge of a triangle, squared.
  static double Longest2(const vec3 p[3]);

  // -1, 1: which side is seen, from all places where rays begin. 0: nearly edge-on.
  int GetSide(const vec3& a, const vec3& b, const vec3& c) const;

private:
  // Of a triangle seen by rays of its own, radians: how far its edges may be off the great circles
  // between its corners. Infinite as near to the circle where rays begin as it is wide.
  double GetAside(const Corner* const c[3]) const;

  // Of the map beside the corners of a triangle.
  struct Local
  {
    double Bound2;  // of the distance of chords from edges, pixels squared
    double Stretch; // pixels a radian
  };
  Local LookAt(const vec3 d[3], double angle2, double aside) const;

  // Pixels that an edge may be off its chord, on the two sides of the way from end to end, and may
  // be beyond an end of it.
  struct Bulge
  {
    double Left = 0;
    double Right = 0;
    double Ends = 0;
    double GetMost() const { return std::max(this->Left, this->Right) + this->Ends; }
  };
  void JudgeEdges(const Corner* const c[3], double angle2, double worst, double moved, Bulge off[3],
    Verdict& verdict) const;
  bool IsEmpty(const Corner* const c[3], double reach) const;
  bool Measure(const Corner* const c[3], double angle2, Bulge off[3]) const;
  // (an edge seen by rays of its own is no great circle)
  Bulge MeasureEdge(const Corner& a, const Corner& b, double most) const;
  unsigned int GetReach(const Corner* const c[3], const Bulge off[3], double sure) const;
  bool MayTearBetween(const Corner& a, const Corner& b) const;
  bool IsTurned(const Corner* const c[3]) const;

  const SortView& V;
  WfvView Seen; // by this eye
  vec2 Scale;
  double Pad;        // pixels, round what is drawn
  double Circle = 0; // radius of that on which rays begin, scene units
};

template <typename Visit>
void TriangleJudge::ForEachPiece(const Corner& from, const Corner& to, const Visit& visit) const
{
  const vec3 chord = to.Direction - from.Direction;
  const double angle2 = glm::dot(chord, chord);
  const bool small = angle2 <= LongestPiece * LongestPiece;
  const bool whole = small && !this->MayTearBetween(from, to);
  const double off = whole ? this->MeasureEdge(from, to, MostKnown).GetMost() : MostKnown;
  if (off < MostKnown)
  {
    const double stretch = 2 * glm::length(to.At - from.At) / std::sqrt(std::max(angle2, 1e-300));
    const double nearest = std::min(from.Distance, to.Distance);
    const double sure = this->Pad + this->GetMoved(nearest, stretch);
    visit(from.At, to.At, off + sure, sure);
    return;
  }
  // (seen by rays of its own, what is beside their circle may jump however short it is)
  const vec3 ends[2] = { glm::normalize(from.Place), glm::normalize(to.Place) };
  const double left2 = glm::dot(ends[1] - ends[0], ends[1] - ends[0]);
  if (!(left2 > ShortestPiece * ShortestPiece) || !(left2 < 4 - 1e-6))
  {
    return;
  }
  const double parts[2] = { glm::length(to.Place), glm::length(from.Place) };
  const Corner middle = // halves the angle
    this->See((from.Place * parts[0] + to.Place * parts[1]) / (parts[0] + parts[1]));
  this->ForEachPiece(from, middle, visit);
  this->ForEachPiece(middle, to, visit);
}
}

#endif
