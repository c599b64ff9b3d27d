// SPDX-License-Identifier: BSD-3-Clause
// Decides for clusters, and where a cluster is mixed for its triangles, how a view draws them.
#ifndef WideFoVClassifier_h
#define WideFoVClassifier_h

#include "Clusters/EyeCircle.h"
#include "Projections/Bounds/ChordLimits.h"
#include "Projections/Bounds/Visibility.h"

#include <memory>

namespace wfv
{
// How triangles are drawn.
enum class DrawClass : unsigned char
{
  Culled,    // not at all: outside the window or the clip spheres
  Projected, // by the vertex stage and the rasterizer: chords are within the tolerance of edges
  Cut,       // likewise, after a geometry stage has cut it into smaller ones
  RayTested, // a geometry stage covers them, the fragment stage decides by rays
  Mixed      // a cluster: each of its triangles has a class of its own
};

// What the classes depend on, but for the mesh.
struct ClassifierView
{
  const Projection* Map = nullptr;
  WfvView View;
  Window Part;                               // of the picture
  std::shared_ptr<const ChordLimits> Limits; // none: nothing is projected
  double Tolerance = 0.25;                   // pixels; that of Limits
  bool Culls = true;
  double EyeRadius = 0;                // of the circle that rays begin on, scene units
  const StereoModel* Stereo = nullptr; // where there is such a circle
  double BaselineRadius = 0;           // of the rays' beginnings from the origin, scene units

  bool operator==(const ClassifierView& other) const;
};

// A triangle's corners, or a cluster, in the map's own frame.
class WFV_EXPORT Classifier
{
public:
  // Chords that stand for an edge, at the most; and for one of a triangle whose edges all have
  // several.
  static constexpr int MostChords = 32;
  static constexpr int MostRows = 4;

  explicit Classifier(const ClassifierView& view);

  // box: of the cluster; radius: of a sphere round the middle of the box that holds it; edge: the
  // longest of its triangles.
  DrawClass OfCluster(const Box& box, double radius, double edge) const;

  // The same of what is to be drawn in one way: how many chords stand for the longest edge, a power
  // of two up to `most`; None, where a ray decides, or Unseen.
  static constexpr int None = 0;
  static constexpr int Unseen = -1;
  int ChordsOfAll(const Box& box, double radius, double edge, int most) const;

  // Of a triangle: a class of its own; and for the edge opposite to each corner the chords that
  // stand for it, 1 to 32 for parts of it that are alike, or 0, where so few do not do. Both
  // triangles at an edge have the same there, so that what is drawn in two ways meets.
  struct Triangle
  {
    DrawClass Class = DrawClass::RayTested;
    int Chords[3] = { 0, 0, 0 };
  };
  Triangle OfTriangle(const vec3& a, const vec3& b, const vec3& c) const;

private:
  int ChordsOf(const vec3& p, const vec3& q, double limit2) const;
  int SeveralChordsOf(const vec3& from, const vec3& to, double times2) const;
  double LimitAt(const vec3& p) const;
  bool IsChord(const vec3& p, const vec3& q, double limit2, bool sampled) const;
  bool FitChords(const vec3& p, const vec3& q, int chords, bool sampled) const;
  bool MayProject(const vec3 p[3]) const;
  bool IsFarEnough(const vec3 p[3], double nearest2, double angle2) const;
  void LeaveDiscontinuousEdges(const vec3 p[3], Triangle& t) const;
  bool MayTear(const vec3 p[3], double farthest, double angle) const;
  bool HasChordsAround(const vec3& centre, double radius, double edge, int chords) const;
  bool SphereMayTear(const vec3& centre, double radius, double angle) const;
  bool IsOnOneFace(const vec3 p[3], double beside) const;

  bool HasCircle() const { return this->Circle.GetRadius() > 0; }

  const ClassifierView& V;
  Family Axis;
  EyeCircle Circle;
  double Inner2; // squared distances: nothing is projected beyond
  double Outer2;
  double RimCosine; // of the angle at which a round map ends
  double RimAngle;  // ChordLimits::GetRimAngle
  bool AllAround;   // the window shows all directions
};
}

#endif
