// SPDX-License-Identifier: BSD-3-Clause
// Samples of the picture that lie so near an edge that its chord may decide otherwise about them.
#ifndef vtkWideFoVEdgeDoubts_h
#define vtkWideFoVEdgeDoubts_h

#include "vtkWideFoVClusters.h"
#include "vtkWideFoVSampleGrid.h"

#include <functional>
#include <vector>

namespace wfv
{
// What is in front of what is decided at the outlines of surfaces: where front meets back, or the
// mesh ends. Beside the chord of an outline a hidden face may show, which is seen nowhere near: if
// a sample is so near the chord that it is in doubt. The two faces that meet there are both drawn
// at it or neither, as they share the chord, but beyond their edge its ray meets the plane of the
// one behind first. Another edge may pass there as well.
class EdgeDoubts
{
public:
  struct Doubt
  {
    unsigned int Sample; // SampleGrid::ForEachNear
    unsigned int Edge;   // 3 times the triangle, and the corner that it begins at
    float Beside;        // pixels, from the chord
    float Width;         // pixels, within which a sample is in doubt
    float Sure;          // pixels, beyond which it is known on which side of the chord it is drawn
  };
  using Lists = std::vector<std::vector<Doubt>>;

  // Pixels: outlines at which samples are in doubt within more than this are covered, so other
  // edges are looked at within this beyond their own widths; outlines within all that a width may
  // be.
  static constexpr double OutlineWidth = 0.04;

  // What the mesh and its sorting so far say.
  struct Mesh
  {
    Clusters& Triangles;
    std::function<bool(unsigned int triangle)> IsPlain; // drawn with chords
    std::function<bool(unsigned int edge)> IsOutline;
    std::function<vec2(unsigned int corner)> At;       // of three a triangle: pixels
    std::function<vec2(unsigned int sample)> SampleAt; // pixels
    std::function<double(const Doubt&)> FromEdge;      // of a sample's ray, radians
    std::function<void(unsigned int triangle)> Cover;  // to be drawn by its edges
    double Tolerance;                                  // pixels
  };

  // What an eye sees of the mesh.
  struct Sight
  {
    Lists Doubts;
    Mesh Seen;
  };

  // Covers the triangles at whose edges a hidden face might show, to any of the eyes.
  static void Settle(const std::vector<Sight>& eyes);

  // Whether a sample may be drawn on the other side of the edge than it is, by the chord of a plain
  // triangle: no sample that is drawn for sure is on different sides of its edges and chords.
  static bool MayBeWrong(const Doubt& doubt) { return doubt.Beside <= doubt.Sure; }
};
}

#endif
