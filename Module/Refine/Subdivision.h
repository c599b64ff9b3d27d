// SPDX-License-Identifier: BSD-3-Clause
// Splits one triangle into pieces. Its working memory is kept from triangle to triangle.
#ifndef WideFoVSubdivision_h
#define WideFoVSubdivision_h

#include "Refine/RefineSpace.h"

#include <vector>

namespace wfv
{
class Subdivision
{
public:
  // Adds the pieces of a triangle.
  void Refine(RefineSpace& space, const WfvEnd corners[3], unsigned int number, Pieces& pieces);

  // The same of a segment.
  void RefineSegment(RefineSpace& space, const WfvEnd ends[2], unsigned int number, Pieces& pieces);

private:
  void Begin(
    RefineSpace& space, const WfvEnd* corners, int count, unsigned int number, Pieces& pieces);
  void Segment(int a, int b, int depth);
  void SegmentLeaf(int a, int b);
  struct Node
  {
    WfvEnd End;
    vec3 Weights;      // of the corners of the triangle
    int InPieces = -1; // its vertex among the pieces, once it has one
  };

  // A strip between two sides, from `Low` to `High` on each; a fan where one side is a point.
  struct Strip
  {
    int Low[2];
    int High[2];
  };

  int Split(int a, int b); // the node in the middle of an edge, or -1
  int Mix(int a, int b, double share);
  void Triangle(int a, int b, int c, int depth);
  void Quads(const Strip& strip, int depth);
  void Piece(int a, int b, int c, int depth);
  double Angle2(int a, int b) const;
  bool IsOutside(int a, int b, int c, int depth) const;

  // Pieces whose edges are all short.
  void Leaf(int a, int b, int c);
  struct Crossings
  {
    int Ahead = 0;
    int Behind = 0;
  };
  Crossings CountCrossings(const int nodes[3]) const;
  void AtMeridian(const int nodes[3]);
  void OnSideOfMeridian(const int nodes[3], double side);
  void AtRim(const int nodes[3]);
  void AtFaces(const int nodes[3]);
  template <typename Measure>
  void Cut(std::vector<int>& polygon, const Measure& measure);
  void AddPolygon(const std::vector<int>& polygon, double aside);
  template <typename AtBorder>
  void AddSkirt(
    const std::vector<int>& polygon, double side, double outside, const AtBorder& atBorder);
  void AddSegment(const std::vector<int>& polygon, double aside);
  void AddPiece(int a, int b, int c, double aside);
  unsigned int VertexOf(int node, double aside);

  int* FindMiddle(int a, int b); // the entry of the table for this edge

  RefineSpace* Space = nullptr;
  Pieces* Out = nullptr;
  unsigned int Number = 0;
  std::vector<Node> Nodes;

  // The middles of edges that were asked for: a hash table by their ends.
  struct Middle
  {
    int A = -1;
    int B = -1;
    int Node = -1;
  };
  std::vector<Middle> Middles;
  int KnownMiddles = 0;

  std::vector<int> Polygon;
  std::vector<int> Clipped;
};
}

#endif
