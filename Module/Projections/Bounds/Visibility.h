// SPDX-License-Identifier: BSD-3-Clause
// What a view surely does not show.
#ifndef WideFoVVisibility_h
#define WideFoVVisibility_h

#include "Projections/Projection.h"

#include <array>

namespace wfv
{
// A box in the map's own frame: view coordinates behind the tilt.
struct Box
{
  vec3 Low{ 1e300 };
  vec3 High{ -1e300 };

  void Add(const vec3& p)
  {
    this->Low = glm::min(this->Low, p);
    this->High = glm::max(this->High, p);
  }

  // The same as seen from any place no farther from the origin.
  void Grow(double by)
  {
    this->Low -= by;
    this->High += by;
  }
};

// The part of the picture that is drawn, NDC, with a margin.
struct Window
{
  vec2 Low{ -1 };
  vec2 High{ 1 };
  vec2 Footprint{ 0 }; // how far a thing may be drawn from its place: wide lines and points
};

// Rectangles of the map, NDC: left, bottom, right, top. They may overlap and reach beyond the
// picture.
struct Pictures
{
  std::array<vec4, 3> Bounds;
  int Count = 0;

  void Add(const vec4& bounds) { this->Bounds[this->Count++] = bounds; }
};

// What surely holds the picture of a box, whatever the clip spheres; footprint: how far a thing may
// be drawn from its place.
WFV_EXPORT Pictures PicturesOf(
  const Projection& projection, const WfvView& view, const Box& box, const vec2& footprint);

// True where no point of the box is between the clip spheres and in the window. Never where one
// is; boxes that are near may be called seen though they are not. In double.
WFV_EXPORT bool IsCulled(
  const Projection& projection, const WfvView& view, const Box& box, const Window& window);

// True where the window shows all directions: then a box is culled where IsBetweenClips is false,
// which takes no arc tangents and no search along the map's border.
WFV_EXPORT bool ShowsAll(const Projection& projection, const WfvView& view, const Window& window);

// Whether a point of the box may be between the clip spheres.
WFV_EXPORT bool IsBetweenClips(const WfvView& view, const Box& box);

// Distances of the nearest and of the farthest point of the box from the eye.
WFV_EXPORT vec2 Distances(const Box& box);
}

#endif
