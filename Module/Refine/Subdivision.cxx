// SPDX-License-Identifier: BSD-3-Clause
#include "Refine/Subdivision.h"

#include <algorithm>
#include <cmath>

namespace wfv
{
namespace
{
// Splits of an edge of a split edge, and so on: an edge past a pole takes some fourteen.
constexpr int MostDepth = 30;

// Pieces of each so many splits are asked whether they are in the picture.
constexpr int CullingDepth = 3;

// Corners of the pieces of one triangle: after so many, none is split any more.
constexpr std::size_t MostNodes = 1000000;

// Asked: no middle.
constexpr int None = -2;
}

void Subdivision::Begin(
  RefineSpace& space, const WfvEnd* corners, int count, unsigned int number, Pieces& pieces)
{
  this->Space = &space;
  this->Out = &pieces;
  this->Number = number;
  this->Nodes.clear();
  this->Middles.assign(64, Middle());
  this->KnownMiddles = 0;
  for (int i = 0; i < count; i++)
  {
    Node node;
    node.End = corners[i];
    node.Weights = vec3(i == 0, i == 1, i == 2);
    this->Nodes.push_back(node);
  }
}

void Subdivision::Refine(
  RefineSpace& space, const WfvEnd corners[3], unsigned int number, Pieces& pieces)
{
  this->Begin(space, corners, 3, number, pieces);
  this->Triangle(0, 1, 2, 0);
}

void Subdivision::RefineSegment(
  RefineSpace& space, const WfvEnd ends[2], unsigned int number, Pieces& pieces)
{
  this->Begin(space, ends, 2, number, pieces);
  this->Segment(0, 1, 0);
}

void Subdivision::Segment(int a, int b, int depth)
{
  if (this->IsOutside(a, b, b, depth))
  {
    return;
  }
  const int middle = this->Split(a, b);
  if (middle == None || depth >= MostDepth)
  {
    this->SegmentLeaf(a, b);
    return;
  }
  this->Segment(a, middle, depth + 1);
  this->Segment(middle, b, depth + 1);
}

// A segment is a triangle with two corners at one place: it is cut in the same way.
void Subdivision::SegmentLeaf(int a, int b)
{
  this->Nodes.push_back(this->Nodes[b]);
  this->Nodes.back().InPieces = -1;
  this->Leaf(a, b, static_cast<int>(this->Nodes.size()) - 1);
}

int* Subdivision::FindMiddle(int a, int b)
{
  if (2 * this->KnownMiddles >= static_cast<int>(this->Middles.size()))
  {
    std::vector<Middle> before(2 * this->Middles.size());
    before.swap(this->Middles);
    this->KnownMiddles = 0;
    for (const Middle& m : before)
    {
      if (m.A >= 0)
      {
        *this->FindMiddle(m.A, m.B) = m.Node;
      }
    }
  }
  const std::size_t mask = this->Middles.size() - 1;
  std::size_t at =
    (static_cast<std::size_t>(a) * 73856093u ^ static_cast<std::size_t>(b) * 19349663u) & mask;
  while (this->Middles[at].A >= 0 && (this->Middles[at].A != a || this->Middles[at].B != b))
  {
    at = (at + 1) & mask;
  }
  if (this->Middles[at].A < 0)
  {
    this->Middles[at] = Middle{ a, b, -1 };
    this->KnownMiddles++;
  }
  return &this->Middles[at].Node;
}

// The ends come in the order of wfvSplitAt, and so do their products: the two triangles at an edge
// get the same bits.
int Subdivision::Mix(int a, int b, double share)
{
  Node node;
  const Node& p = this->Nodes[a];
  const Node& q = this->Nodes[b];
  node.End = this->Space->wfvEndAt(p.End.place * (1 - share) + q.End.place * share);
  node.Weights = p.Weights * (1 - share) + q.Weights * share;
  this->Nodes.push_back(node);
  return static_cast<int>(this->Nodes.size()) - 1;
}

int Subdivision::Split(int a, int b)
{
  if (a == b || this->Nodes.size() >= MostNodes)
  {
    this->Out->Limited = this->Out->Limited || a != b;
    return None;
  }
  const bool ordered = RefineSpace::ComesFirst(this->Nodes[a].End, this->Nodes[b].End);
  const int from = ordered ? a : b;
  const int to = ordered ? b : a;
  int& middle = *this->FindMiddle(from, to);
  if (middle != -1)
  {
    return middle;
  }
  const double share = this->Space->wfvSplitAt(this->Nodes[from].End, this->Nodes[to].End);
  middle = share > 0 ? this->Mix(from, to, share) : None;
  return middle;
}

// Squared, of the angle between two nodes, as seen from the nearer one.
double Subdivision::Angle2(int a, int b) const
{
  const WfvEnd& p = this->Nodes[a].End;
  const WfvEnd& q = this->Nodes[b].End;
  const vec3 way = q.place - p.place;
  return glm::dot(way, way) /
    std::max(1e-300, std::min(glm::dot(p.place, p.place), glm::dot(q.place, q.place)));
}

bool Subdivision::IsOutside(int a, int b, int c, int depth) const
{
  const vec3& p = this->Nodes[a].End.place;
  const vec3& q = this->Nodes[b].End.place;
  const vec3& r = this->Nodes[c].End.place;
  return this->Space->IsOutside(p, q, r) ||
    (depth > 0 && depth % CullingDepth == 0 && this->Space->IsCulled(p, q, r));
}

// One with two split edges becomes a strip between these, one with one becomes a fan: to make four
// of every triangle takes many times the pieces where one is thin.
void Subdivision::Triangle(int a, int b, int c, int depth)
{
  if (this->IsOutside(a, b, c, depth))
  {
    return;
  }
  const int middles[3] = { this->Split(b, c), this->Split(c, a), this->Split(a, b) };
  const int nodes[3] = { a, b, c };
  const int split = (middles[0] != None) + (middles[1] != None) + (middles[2] != None);
  if (split == 0 || depth >= MostDepth)
  {
    this->Leaf(a, b, c);
    return;
  }
  if (split == 3)
  {
    this->Triangle(a, middles[2], middles[1], depth + 1);
    this->Triangle(middles[2], b, middles[0], depth + 1);
    this->Triangle(middles[1], middles[0], c, depth + 1);
    this->Triangle(middles[0], middles[1], middles[2], depth + 1);
    return;
  }
  for (int i = 0; i < 3; i++)
  {
    const int apex = nodes[i];
    const int next = nodes[(i + 1) % 3];
    const int last = nodes[(i + 2) % 3];
    if (split == 2 && middles[i] == None)
    {
      this->Quads(Strip{ { apex, apex }, { next, last } }, depth);
    }
    if (split == 1 && middles[i] != None)
    {
      this->Quads(Strip{ { next, apex }, { last, apex } }, depth);
    }
  }
}

// Both sides are halved alike, so that the rungs between them stay as short as the ends.
void Subdivision::Quads(const Strip& s, int depth)
{
  if (this->IsOutside(s.Low[0], s.High[0], s.High[1], depth) &&
    this->IsOutside(s.Low[0], s.Low[1], s.High[1], depth))
  {
    return;
  }
  const int middles[2] = { this->Split(s.Low[0], s.High[0]), this->Split(s.Low[1], s.High[1]) };
  if ((middles[0] == None && middles[1] == None) || depth >= MostDepth)
  {
    // the shorter diagonal; rungs that are too long after all are split as well
    const bool first = this->Angle2(s.Low[0], s.High[1]) <= this->Angle2(s.High[0], s.Low[1]);
    this->Piece(s.Low[0], s.High[0], first ? s.High[1] : s.Low[1], depth + 1);
    this->Piece(first ? s.Low[0] : s.High[0], s.High[1], s.Low[1], depth + 1);
    return;
  }
  int at[2];
  for (int i = 0; i < 2; i++)
  {
    const int other = middles[1 - i];
    const bool low =
      middles[i] == None && this->Angle2(other, s.Low[i]) <= this->Angle2(other, s.High[i]);
    at[i] = middles[i] != None ? middles[i] : low ? s.Low[i] : s.High[i];
  }
  this->Quads(Strip{ { s.Low[0], s.Low[1] }, { at[0], at[1] } }, depth + 1);
  this->Quads(Strip{ { at[0], at[1] }, { s.High[0], s.High[1] } }, depth + 1);
}

// A half of a quadrilateral, none where two of its corners are one.
void Subdivision::Piece(int a, int b, int c, int depth)
{
  if (a != b && b != c && c != a)
  {
    this->Triangle(a, b, c, depth);
  }
}

void Subdivision::Leaf(int a, int b, int c)
{
  const int nodes[3] = { a, b, c };
  const WfvEnd ends[3] = { this->Nodes[a].End, this->Nodes[b].End, this->Nodes[c].End };
  const vec2 radii = this->Space->GetView().View.radii;
  double nearest = ends[0].distance;
  double farthest = nearest;
  for (const WfvEnd& e : ends)
  {
    nearest = std::min(nearest, e.distance);
    farthest = std::max(farthest, e.distance);
  }
  if (!(nearest > 0) || farthest < radii.x || nearest > 1.01 * radii.y)
  {
    return; // nothing of it is between the clip spheres
  }
  if (this->Space->IsWhole(ends))
  {
    this->AddPiece(a, b, c, 0);
    return;
  }
  switch (this->Space->GetNumbers().tears)
  {
    case WFV_TEARS_MERIDIAN:
      this->AtMeridian(nodes);
      break;
    case WFV_TEARS_AZIMUTHAL:
      this->AtRim(nodes);
      break;
    case WFV_TEARS_FACES:
      this->AtFaces(nodes);
      break;
    default: // beyond the end of a plane
      break;
  }
}

// Cuts a convex polygon off where measure, of an end, is below 0.
template <typename Measure>
void Subdivision::Cut(std::vector<int>& polygon, const Measure& measure)
{
  this->Clipped.clear();
  for (std::size_t i = 0; i < polygon.size(); i++)
  {
    const int from = polygon[i];
    const int to = polygon[(i + 1) % polygon.size()];
    const double here = measure(this->Nodes[from].End);
    const double there = measure(this->Nodes[to].End);
    if (here >= 0)
    {
      this->Clipped.push_back(from);
    }
    if ((here > 0 && there < 0) || (here < 0 && there > 0))
    {
      const bool ordered = RefineSpace::ComesFirst(this->Nodes[from].End, this->Nodes[to].End);
      const double share = ordered ? here / (here - there) : there / (there - here);
      this->Clipped.push_back(ordered ? this->Mix(from, to, share) : this->Mix(to, from, share));
    }
  }
  polygon.swap(this->Clipped);
}

// How often the border of a triangle crosses the half plane behind the eye, and that before it.
Subdivision::Crossings Subdivision::CountCrossings(const int nodes[3]) const
{
  Crossings count;
  for (int i = 0; i < 3; i++)
  {
    const vec3& p = this->Nodes[nodes[i]].End.seen;
    const vec3& q = this->Nodes[nodes[(i + 1) % 3]].End.seen;
    if ((p.x < 0) != (q.x < 0))
    {
      const bool back = p.z + (q.z - p.z) * (p.x / (p.x - q.x)) > 0;
      (back ? count.Behind : count.Ahead)++;
    }
  }
  return count;
}

// Cuts a triangle at the half plane behind the eye. A triangle that is before and behind holds the
// pole, and is too small to be seen.
void Subdivision::AtMeridian(const int nodes[3])
{
  const Crossings count = this->CountCrossings(nodes);
  if (count.Behind == 1)
  {
    return;
  }
  if (count.Behind == 0 && count.Ahead > 0)
  {
    this->AddPiece(nodes[0], nodes[1], nodes[2], 0);
    return;
  }
  this->OnSideOfMeridian(nodes, -1);
  this->OnSideOfMeridian(nodes, 1);
}

void Subdivision::OnSideOfMeridian(const int nodes[3], double side)
{
  const auto measure = [side](const WfvEnd& e) {
    const double x = side * e.seen.x;
    return std::abs(x) <= RefineSpace::Beside * e.distance ? 0 : x;
  };
  // a segment in the plane of the seam is shown on both sides, a triangle there is seen edge-on
  const bool segment = this->Out->Corners == 2;
  const auto isAcross = [&](int node) {
    const double x = measure(this->Nodes[node].End);
    return x < 0 || (x == 0 && !segment);
  };
  if (std::all_of(nodes, nodes + 3, isAcross))
  {
    return;
  }
  this->Polygon.assign(nodes, nodes + 3);
  this->Cut(this->Polygon, measure);
  this->AddPolygon(this->Polygon, side);
  if (!this->Space->GetView().Map->StraightSeam)
  {
    this->AddSkirt(this->Polygon, side, 2 * side, [&](int node) {
      const WfvEnd& e = this->Nodes[node].End;
      return measure(e) == 0 && e.seen.z > 0;
    });
  }
}

// Two triangles reach from each chord of a curved border across it. atBorder: whether a node is
// there.
template <typename AtBorder>
void Subdivision::AddSkirt(
  const std::vector<int>& polygon, double side, double outside, const AtBorder& atBorder)
{
  if (this->Out->Corners == 2 || this->Space->GetNumbers().depthBend > 0)
  {
    return; // the border of a picture that is shifted by depth is elsewhere at each depth
  }
  for (std::size_t i = 0; i < polygon.size(); i++)
  {
    const int a = polygon[i];
    const int b = polygon[(i + 1) % polygon.size()];
    if (atBorder(a) && atBorder(b))
    {
      const unsigned int inner[2] = { this->VertexOf(a, side), this->VertexOf(b, side) };
      const unsigned int outer[2] = { this->VertexOf(a, outside), this->VertexOf(b, outside) };
      this->Out->Indices.insert(
        this->Out->Indices.end(), { inner[0], outer[0], outer[1], inner[0], outer[1], inner[1] });
      this->Out->Numbers.insert(this->Out->Numbers.end(), 2, this->Number);
    }
  }
}

// Beyond the rim of a round map there is nothing. Where no triangles are cut there, the fragment
// stage leaves out what is beyond.
void Subdivision::AtRim(const int nodes[3])
{
  const WfvRefine& numbers = this->Space->GetNumbers();
  if (!(numbers.rimChord > 0))
  {
    this->AddPiece(nodes[0], nodes[1], nodes[2], 0);
    return;
  }
  const double cosine = numbers.rimCosine;
  this->Polygon.assign(nodes, nodes + 3);
  const auto known = static_cast<int>(this->Nodes.size());
  this->Cut(this->Polygon, [cosine](const WfvEnd& e) { return -e.seen.z / e.distance - cosine; });
  this->AddPolygon(this->Polygon, 0);
  this->AddSkirt(this->Polygon, 0, 2, [known](int node) { return node >= known; });
}

void Subdivision::AtFaces(const int nodes[3])
{
  for (int face = 1; face <= 6; face++)
  {
    const int axis = (face - 1) / 2;
    const double sign = face % 2 ? -1 : 1;
    this->Polygon.assign(nodes, nodes + 3);
    for (int k = 1; k < 3; k++)
    {
      for (const double side : { -1.0, 1.0 })
      {
        const int other = (axis + k) % 3;
        this->Cut(this->Polygon, [=](const WfvEnd& e) {
          const double inside = sign * e.seen[axis] - side * e.seen[other];
          return std::abs(inside) <= RefineSpace::Beside * e.distance ? 0 : inside;
        });
      }
    }
    this->AddPolygon(this->Polygon, face);
  }
}

void Subdivision::AddPolygon(const std::vector<int>& polygon, double aside)
{
  if (this->Out->Corners == 2)
  {
    this->AddSegment(polygon, aside);
    return;
  }
  for (std::size_t i = 2; i < polygon.size(); i++)
  {
    this->AddPiece(polygon[0], polygon[i - 1], polygon[i], aside);
  }
}

// A segment's polygon is flat. Its part lies between the two nodes that are farthest apart along
// it.
void Subdivision::AddSegment(const std::vector<int>& polygon, double aside)
{
  if (polygon.size() < 2)
  {
    return;
  }
  const auto along = [this](int p, int q) {
    return this->Nodes[p].Weights.y < this->Nodes[q].Weights.y;
  };
  const auto [first, last] = std::minmax_element(polygon.begin(), polygon.end(), along);
  if (this->Nodes[*first].Weights.y < this->Nodes[*last].Weights.y)
  {
    this->AddPiece(*first, *last, *last, aside);
  }
}

void Subdivision::AddPiece(int a, int b, int c, double aside)
{
  const int nodes[3] = { a, b, c };
  for (int i = 0; i < this->Out->Corners; i++)
  {
    this->Out->Indices.push_back(this->VertexOf(nodes[i], aside));
  }
  this->Out->Numbers.push_back(this->Number);
}

unsigned int Subdivision::VertexOf(int node, double aside)
{
  Node& n = this->Nodes[node];
  const bool shared = aside == 0;
  if (shared && n.InPieces >= 0)
  {
    return static_cast<unsigned int>(n.InPieces);
  }
  const auto index = static_cast<unsigned int>(this->Out->Vertices.size());
  PieceVertex vertex;
  vertex.Weights = { n.Weights.x, n.Weights.y, n.Weights.z };
  vertex.Aside = static_cast<float>(aside);
  this->Out->Vertices.push_back(vertex);
  this->Out->Sources.push_back(this->Number);
  if (shared)
  {
    n.InPieces = static_cast<int>(index);
  }
  return index;
}
}
