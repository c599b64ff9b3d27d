// SPDX-License-Identifier: BSD-3-Clause
// refine_chord.glsl and refine.glsl as C++: the questions that edges and triangles ask of a view.
#ifndef WideFoVRefineSpace_h
#define WideFoVRefineSpace_h

#include "Refine/Refiner.h"

namespace wfv
{
#define float double
#include "Refine/refine_types.glsl"
#undef float

class RefineSpace
{
public:
  explicit RefineSpace(const RefineView& view);

  // Relative to the distance: so near a discontinuity float32 may place a point beyond it.
  static constexpr double Beside = 1e-5;

  const RefineView& GetView() const { return this->V; }
  const WfvRefine& GetNumbers() const { return this->wfvRefine; }
  Refiner::Need OfCluster(const Box& box, double radius, double edge) const;

  // True where an end is at a distance that float32 and the clip spheres are made for.
  bool IsOrdinary(const WfvEnd& e) const
  {
    return e.distance > 0 && e.reach >= this->NearReach &&
      e.reach <= WFV_BEYOND * this->V.View.radii.y;
  }

  // The order in which wfvSplitAt takes the ends of an edge.
  static bool ComesFirst(const WfvEnd& a, const WfvEnd& b)
  {
    const vec3& p = a.place;
    const vec3& q = b.place;
    return p.x != q.x ? p.x < q.x : p.y != q.y ? p.y < q.y : p.z < q.z;
  }

  // True where an edge is drawn as it is: both ends are ordinary, and a chord stands for it.
  bool IsShort(const WfvEnd& a, const WfvEnd& b)
  {
    const bool ordered = ComesFirst(a, b);
    return this->IsOrdinary(a) && this->IsOrdinary(b) &&
      !(this->wfvSplitAt(ordered ? a : b, ordered ? b : a) > 0);
  }

  // True where the eye lies in the plane of a triangle: nothing of it can be seen.
  bool IsEdgeOn(const vec3& p, const vec3& q, const vec3& r) const;

  // True where nothing of a triangle can be in the picture, whatever its edges.
  bool IsOutside(const vec3& p, const vec3& q, const vec3& r) const;

  // True where nothing of the box round a triangle can be in the picture. It takes longer to say.
  bool IsCulled(const vec3& p, const vec3& q, const vec3& r) const;

  // True where a triangle of short edges has one picture, without a gap.
  bool IsWhole(const WfvEnd ends[3]) const;

#define float double
#define WFV_END const WfvEnd&
#include "Refine/refine_eyes.glsl"
#include "Refine/refine_chord.glsl"
#include "Refine/refine.glsl"
#undef WFV_END
#undef float

private:
  WfvEnd wfvSeeEnd(const vec3& place) const;
  double wfvLimitOf(const vec3& seen) const
  {
    return this->V.Limits->At(seen);
  }
  double wfvStretchOf(const vec3& seen) const
  {
    return this->V.Limits->StretchAt(seen);
  }
  vec2 wfvPixelOf(const vec3& seen, double distance);
  bool IsCulled(Box box) const;
  bool IsBesidePicture(const vec3& p, const vec3& q, const vec3& r) const;
  bool IsSteep(const vec3& p, const vec3& q, const vec3& r) const;
  void SetEnd();
  void SetPlanes();
  void SetMeridianEnds();
  bool SphereMayTear(const vec3& centre, double radius) const;
  double LimitAround(const vec3& centre, double radius, double edge) const;
  double LimitOfCircle(const vec3& centre, double radius, double edge) const;

  const RefineView V;
  const bool AllAround; // the window shows all directions
  const WfvView wfvView;
  WfvRefine wfvRefine;
  std::vector<vec3> Planes; // normals, outwards
  std::vector<vec3> Wedge;  // two: what is beyond both is not in the picture
  double MostAzimuth = 4;   // radians: beyond it nothing is in the picture
  double MostSine = 2;      // of the elevation beyond which nothing is in the picture
  double NearReach = 0;     // wfvNearReach(WFV_INSIDE)
  const vec4 wfvPicture;    // its size, pixels, is in the last two
};

// True where three places are on one face of the cube round the eye, so far from its borders.
bool IsOnOneFace(const vec3& a, const vec3& b, const vec3& c, double beside);
}

#endif
