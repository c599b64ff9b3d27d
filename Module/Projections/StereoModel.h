// SPDX-License-Identifier: BSD-3-Clause
// What a view asks of a stereo model. The models themselves: Stereo/Stereo.h.
#ifndef WideFoVStereoModel_h
#define WideFoVStereoModel_h

#include "ProjectionMath.h"

#include <array>
#include <string>

namespace wfv
{
struct Projection;
struct StereoModel;

// Which of the eyes a view is that of.
enum class Eye
{
  Left = -1,
  Middle = 0, // between them: the picture without stereo
  Right = 1
};

// What a user sets. Angles in degrees; each model looks at its own alone.
struct StereoOptions
{
  const StereoModel* Model = nullptr; // none: both eyes see the same
  wfv::Eye Eye = wfv::Eye::Middle;

  double InterpupillaryDistance = 0.065;      // omnidirectional: scene units
  std::array<double, 2> PoleFade{ { 0, 0 } }; // omnidirectional: latitudes; equal: no fade

  double Iod = 0.5;     // warped: between the eyes, NDC
  double Distance = 5;  // warped: of the viewer from the plane of zero parallax, NDC
  double Offset = -0.8; // warped: that plane, NDC depth
  std::array<double, 2> Viewer{ { 0, 0 } }; // warped: between the eyes, NDC off the cube's axis

  double Separation = 0.03; // offaxis: parallax far away, fraction of the picture's width
  double Convergence = 10;  // offaxis: distance of zero parallax, scene units
};

// All that is known of a stereo model.
struct StereoModel
{
  std::string Name;     // as on the command line
  std::string Title;    // for people
  bool Straight = true; // the rays are straight lines
  bool OwnRays = false; // the rays of one eye begin in several places
  std::string Glsl;     // source text of its files

  // wfvSee: the direction in which the eye sees a point, and how far along its ray; tilted view
  // coordinates, scene units.
  WfvSight (*See)(vec3 point, WfvView view) = nullptr;

  // wfvEyeAt: where the ray of a direction (unit length) begins.
  vec3 (*EyeAt)(vec3 direction, WfvView view) = nullptr;

  // wfvShift: the place in the eye's picture of what the map puts at ndc with this depth, -1 on the
  // near and 1 on the far clip sphere.
  vec2 (*Shift)(vec2 ndc, double depth, WfvView view) = nullptr;

  // wfvUnshift: its inverse.
  vec2 (*Unshift)(vec2 ndc, double depth, WfvView view) = nullptr;

  // What WfvView::stereo is; view: complete but for it.
  vec4 (*Parameters)(const StereoOptions& options, const WfvView& view) = nullptr;

  // True where the circle that rays begin on is smaller for some latitudes.
  bool Fades(const WfvView& view) const { return this->OwnRays && view.stereo.z > view.stereo.y; }

  // An empty string, or why these options do not fit this model or this projection.
  std::string (*Check)(const StereoOptions& options, const Projection& projection) = nullptr;
};
}

#endif
