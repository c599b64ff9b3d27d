// SPDX-License-Identifier: BSD-3-Clause
// What a view asks of a stereo model. The models themselves: Stereo/Stereo.h.
#ifndef WideFoVStereoModel_h
#define WideFoVStereoModel_h

#include "ProjectionMath.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace wfv
{
struct Projection;
struct StereoModel;

// Which of the eyes a view is that of.
enum class Eye
{
  Left = WFV_EYE_LEFT,
  Middle = WFV_EYE_MIDDLE, // between them: the picture without stereo
  Right = WFV_EYE_RIGHT
};

// The other one of two eyes (WfvView::eye); the middle has none.
constexpr int OtherEye(int eye)
{
  return eye == WFV_EYE_LEFT ? WFV_EYE_RIGHT : eye == WFV_EYE_RIGHT ? WFV_EYE_LEFT : eye;
}

// Where to take half the distance between the eyes: -1 to the left, 1 to the right, 0 nowhere.
constexpr int SideOf(Eye eye)
{
  return eye == Eye::Left ? -1 : eye == Eye::Right ? 1 : 0;
}

// What a model is, to all that draws, culls or offers pictures of two eyes: nothing else asks which
// model it is.
struct StereoTraits
{
  bool TwoEyes = true;      // they see differently
  bool OneCenter = true;    // the rays of an eye begin in one place; else see the class
  bool StraightRays = true; // else they are lines of the cube of the map with its depth
  bool Flat = false;        // for a perspective; else for all other projections
};

// The numbers that models have.
enum class StereoNumber
{
  InterpupillaryDistance,
  PoleFade,
  CircleConvergence,
  Iod,
  Distance,
  Offset,
  Viewer,
  Separation,
  Convergence
};

// What a user sets. Angles in degrees; each model looks at its own alone.
struct StereoOptions
{
  const StereoModel* Model = nullptr; // none: both eyes see the same
  wfv::Eye Eye = wfv::Eye::Middle;

  // eyes in the scene
  double InterpupillaryDistance = 0.065;      // scene units
  std::array<double, 2> PoleFade{ { 0, 0 } }; // latitudes; equal: no fade
  double CircleConvergence = 0; // level distance of zero parallax, scene units; 0: infinite

  // eyes before the cube of the map with its depth
  double Iod = 0.5;                         // between the eyes, NDC
  double Distance = 5;                      // of the viewer from the plane of zero parallax, NDC
  double Offset = -0.8;                     // that plane, NDC depth
  std::array<double, 2> Viewer{ { 0, 0 } }; // between the eyes, NDC off the cube's axis

  // eyes before a flat picture
  double Separation = 0.03; // parallax far away, fraction of the picture's width
  double Convergence = 10;  // distance of zero parallax, scene units
};

// Of both eyes.
struct StereoParameters
{
  double HalfEyes = 0; // what WfvView::halfEyes is
  vec4 Others{ 0 };    // what WfvView::stereo is
};

// Where an eye has no one center, its rays begin on a level circle round the origin, whose radius
// is at most half the distance between the eyes; the file of such a model has two functions more:
// wfvFades, and wfvSeeAt (lines/line_noncentral.glsl).
struct StereoModel
{
  std::string Name;  // as on the command line
  std::string Title; // for people
  StereoTraits Traits;
  std::vector<StereoNumber> Numbers; // those that it has
  std::string Glsl;                  // source text of its files

  // wfvSee: the direction in which the eye sees a point, and how far along its ray; tilted view
  // coordinates, scene units.
  WfvRayHit (*See)(vec3 point, WfvView view) = nullptr;

  // wfvEyeAt: where the ray of a direction (unit length) begins.
  vec3 (*EyeAt)(vec3 direction, WfvView view) = nullptr;

  // wfvShift: the place in the eye's picture of what the map puts at ndc with this depth, -1 on the
  // near and 1 on the far clip sphere.
  vec2 (*Shift)(vec2 ndc, double depth, WfvView view) = nullptr;

  // wfvUnshift: its inverse.
  vec2 (*Unshift)(vec2 ndc, double depth, WfvView view) = nullptr;

  // What WfvView::halfEyes and WfvView::stereo are; view: complete but for them.
  StereoParameters (*Parameters)(const StereoOptions& options, const WfvView& view) = nullptr;

  // True where the circle that rays begin on is smaller for some latitudes; none: it never is.
  bool (*FadesIn)(WfvView view) = nullptr;

  // Whether it is smaller for some in this view.
  bool Fades(const WfvView& view) const { return this->FadesIn && this->FadesIn(view); }

  // NDC depth of what has no parallax.
  double (*DepthWithoutParallax)(const WfvView& view) = nullptr;

  // Whether the model has this number.
  bool Has(StereoNumber number) const
  {
    return std::find(this->Numbers.begin(), this->Numbers.end(), number) != this->Numbers.end();
  }

  // An empty string, or why these options do not fit this model or this projection.
  std::string (*Check)(const StereoOptions& options, const Projection& projection) = nullptr;
};
}

#endif
