// SPDX-License-Identifier: BSD-3-Clause
// The views and the directions that the checks of the projections run through.
#ifndef WideFoVTestViews_h
#define WideFoVTestViews_h

#include "Projections/Projection.h"

#include <string>
#include <vector>

namespace wfv
{
namespace test
{
const double Degree = WFV_PI / 180;

// Twice the area of the triangle between two sides, positive where b is to the left of a.
inline double Cross(const vec2& a, const vec2& b)
{
  return a.x * b.y - a.y * b.x;
}

struct NamedView
{
  std::string Name; // projection and options, for messages
  ViewOptions Options;
  View TheView;
  bool HasLens;
};

// One view, its name made from the options.
NamedView MakeView(const Projection& projection, const ViewOptions& options);

// Every projection x fields of view from 0.001 degrees (where it has more than one) to its largest
// x tilts x (where it takes one) lenses.
std::vector<NamedView> AllViews();

// Lenses of a projection that grow everywhere up to half the field of view (degrees) and have r = 1
// there; none where it takes none.
std::vector<LensCoefficients> Lenses(const Projection& projection, double fov);

// Directions in the frame of the map: the axes and the diagonals of the cube, and points
// `offset` radians from the axis, the poles, the antipode, the seam and the equator.
std::vector<vec3> SpecialDirections(double offset);

// Uniform on the sphere, always the same ones.
std::vector<vec3> RandomDirections(int count);

// 20,000 of them, and the special ones from 1e-9 to 0.1 radians.
std::vector<vec3> ManyDirections();

// Directions `offset` radians inside the rim of a round map, or the largest longitude and
// latitude of a meridian one; none for the others.
std::vector<vec3> RimDirections(const View& view, double offset);

// All of the above, at 1e-9 and larger offsets, turned by the tilt into view coordinates.
std::vector<vec3> DirectionsFor(const View& view);

// Whether the map has a place for a direction (view coordinates).
bool InDomain(const View& view, const vec3& direction);

// The angles the map of this family is a function of: (lambda, phi) or (azimuth, theta).
vec2 AnglesOf(const Projection& projection, const vec3& mapDirection);

// "(x, y, z)" with 17 digits.
std::string Text(const vec3& v);
std::string Text(const vec2& v);
}
}

#endif
