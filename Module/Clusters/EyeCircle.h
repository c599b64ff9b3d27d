// SPDX-License-Identifier: BSD-3-Clause
// What rays that begin on a circle change of the edges and triangles that they see.
#ifndef WideFoVEyeCircle_h
#define WideFoVEyeCircle_h

#include "Projections/Bounds/ChordLimits.h"
#include "Projections/StereoModel.h"

namespace wfv
{
// The circle that the rays of both eyes begin on, each at a place of its own. Its axis is upright
// in the view, whatever the tilt, and it has one radius: where that fades, nothing asks. Lengths
// are in scene units, places in the map's own frame.
class EyeCircle
{
public:
  // Radii: what is nearer to the axis is ray-tested.
  static constexpr double LeastRadii = 1.5;

  // limits: of the map, for this tolerance, pixels; radius: 0 where rays begin in one place.
  EyeCircle(const WfvView& view, const StereoModel* stereo, double radius,
    const ChordLimits* limits, double tolerance);

  double GetRadius() const { return this->Radius; }

  // ChordLimits::At of what the eyes see there: rays look aside of the direction from the middle,
  // and see an edge under a larger angle than it does.
  double LimitAt(const vec3& p) const;

  // The least of these in a sphere, less what the circle turns an edge of this length.
  double LimitAround(const vec3& centre, double radius, double edge) const;

  // Whether what the map curves of an edge and what the circle turns of it are within the tolerance
  // together. p: an end; edge2: its squared length; limit2: that of a chord by LimitAt.
  bool IsShort(const vec3& p, double edge2, double limit2) const;

  // Whether a chord stands for the edge in the pictures of both eyes.
  bool HasChord(const vec3& p, const vec3& q, double limit2) const;

  // Of a map of meridians, whether an eye may see a triangle so near the seam. longest: of its
  // edges.
  bool MaySeeAtSeam(const vec3 p[3], double longest, double beside) const;

private:
  double AxisDistance2(const vec3& p) const;
  bool IsNearAxis(const vec3& p, double edge2) const;
  double TurningOf(const vec3& p, double edge2) const;
  vec3 SeenBy(int eye, const vec3& p) const;

  const WfvView& View;
  const StereoModel* Stereo;
  double Radius;
  const ChordLimits* Limits;
  double Tolerance;
};

// Whether a triangle comes so near to the half plane behind the eye, where the seam of a map of
// meridians is.
bool IsAtSeam(const vec3 p[3], double beside);
}

#endif
