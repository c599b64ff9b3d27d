// SPDX-License-Identifier: BSD-3-Clause
// The registry of projections: pure mathematics, no VTK. Everything that offers,
// draws, checks or documents a projection reads it from here.
#ifndef WideFoVProjection_h
#define WideFoVProjection_h

#include "ProjectionMath.h"
#include "StereoModel.h"

#include <array>
#include <memory>
#include <string>
#include <vector>

#if defined(_WIN32)
#define WFV_EXPORT
#else
#define WFV_EXPORT __attribute__((visibility("default")))
#endif

namespace wfv
{
struct ViewOptions;

// Where the two angles of a map are measured.
enum class Family
{
  Meridian,  // (lambda, phi) about the vertical axis; a seam behind, poles above and below
  Azimuthal, // (azimuth, theta) about -z; round maps; the antipode behind
  Planar,    // straight lines stay straight; nothing behind the eye
  Faces,     // the six faces of a cube, side by side; discontinuous at their borders
  Sampled    // no formula: a direction for each pixel (DirectionMap.h)
};

// All that is known of a projection.
struct Projection
{
  std::string Name;       // as on the command line
  std::string Title;      // for people
  std::string Properties; // "equidistant", "equal-area", ..., asserted by the tests
  Family Axis = Family::Meridian;
  double MinHorizontalFov = 0;   // degrees; 0: anything above it
  double MaxHorizontalFov = 360; // degrees; half of each is where the domain ends
  double MinVerticalFov = 0;     // degrees, likewise
  double MaxVerticalFov = 180;   // degrees
  std::string Limit;             // why these are the limits, where they are not the sphere's
  bool HasLens = false;          // takes the lens polynomial
  bool StraightSeam = true;      // the seam is drawn as a straight line
  bool UnboundedPoles = false;   // a pole is stretched to a segment of the border
  bool FlatRim = false;          // a round map whose radius has no slope at 90 degrees
  bool Framed = false;           // a round map seen in the rectangle of both fields of view
  std::string Glsl;              // source text of its files

  // wfvMap: NDC of the family's two angles, radians.
  vec2 (*Map)(vec2 angles, WfvView view) = nullptr;

  // wfvProject: NDC of a direction of any length, tilted view coordinates.
  vec2 (*Project)(vec3 direction, WfvView view) = nullptr;

  // wfvUnproject: the unit direction there, tilted view coordinates; outside, where the map has
  // none, the one that is nearest. Never NaN.
  WfvRay (*Unproject)(vec2 ndc, WfvView view) = nullptr;

  // wfvBounds: an NDC rectangle (x min, y min, x max, y max) that surely holds a rectangle of the
  // two angles, radians, in the same order.
  vec4 (*Bounds)(vec4 angles, WfvView view) = nullptr;
};

// Those that are formulas.
WFV_EXPORT const std::vector<Projection>& Projections();

// The one that draws what ViewOptions::Map says, "direction-map".
WFV_EXPORT const Projection& SampledProjection();

// All of them: the formulas, then the sampled one.
WFV_EXPORT std::vector<const Projection*> AllProjections();

// The perspective as a round map, framed by its fields of view: what the techniques draw of it
// (vtkWideFoVCamera::SetExactPerspective). No list has it; its name is the perspective's.
WFV_EXPORT const Projection& FramedPerspective();

// True where the frame lies in the round map: its corners within 80 degrees of the axis, which is
// in the middle.
WFV_EXPORT bool FitsFrame(const ViewOptions& options);

// The projection of that name, of all, or nullptr.
WFV_EXPORT const Projection* FindProjection(const std::string& name);

// Source text of common.glsl.
WFV_EXPORT const char* CommonGlsl();

// Source text of depth.glsl.
WFV_EXPORT const char* DepthGlsl();

// Source text of glsl_math.glsl.
WFV_EXPORT const char* MathGlsl();

// How a distance becomes a depth (depth.glsl).
enum class DepthMapping
{
  Linear = WFV_DEPTH_LINEAR,
  Logarithmic = WFV_DEPTH_LOGARITHMIC,
  Reversed = WFV_DEPTH_REVERSED
};

// c1 to c9 of r = c1 t + .. + c9 t^9, t the radius of the ideal lens; all zeros: that lens. r is 1
// at the rim of the picture, unless the picture was measured.
using LensCoefficients = std::array<double, 9>;

// Where a round map lies in a picture, as cameras are calibrated: pixels of that picture, from the
// upper left corner of its first one. Other pictures show it as large as it fits, in their middle.
struct MeasuredPicture
{
  vec2 Size{ 0, 0 };  // of the picture; none: the rim touches the nearer borders of any
  vec2 Axis{ 0, 0 };  // where the axis is: the principal point
  vec2 Focal{ 1, 1 }; // pixels of the radius 1 of the map, along x and y: the focal lengths

  // True where a picture was measured.
  bool IsSet() const { return this->Size.x > 0; }
};

// What a user sets; degrees.
struct ViewOptions
{
  double HorizontalFov = 360;                    // of round maps the one across
  double VerticalFov = 180;                      // round maps have none
  double Tilt = 0;                               // how far the axis is raised, -180 to 180
  LensCoefficients Lens{};                       // of projections that have one
  MeasuredPicture Measured;                      // of round maps
  std::array<double, 2> Radii{ { 0.01, 1000 } }; // of the clip spheres, scene units: near, far
  DepthMapping Mapping = DepthMapping::Linear;   // how a distance becomes a depth
  double Aspect = 2;   // width / height of the viewport in pixels; round maps use it
  vec2 Center{ 0, 0 }; // where the axis of a perspective is in the picture, NDC; others ignore it
  std::shared_ptr<const DirectionMap> Map; // of the sampled projection; none: shows nothing
  StereoOptions Stereo;
};

// An empty string, or why these options do not fit this projection.
WFV_EXPORT std::string CheckOptions(const Projection& projection, const ViewOptions& options);

// True where r(t) of the lens grows on all of [0, most].
WFV_EXPORT bool LensIsMonotone(const LensCoefficients& lens, double most);

// True where the radius through this lens grows on all of [0, maxAngle] (radians).
WFV_EXPORT bool LensFits(
  const Projection& projection, const LensCoefficients& lens, double maxAngle);

// Radius in the raw map of a round projection, in pixels divided by the focal length, at the angle
// theta (radians) from the axis, through the options' lens.
WFV_EXPORT double RadiusAt(const Projection& projection, const ViewOptions& options, double theta);

// Where a point is in the picture.
struct NdcPoint
{
  vec3 Ndc;    // depth -1 on the near, +1 on the far clip sphere
  bool Inside; // in the domain of the map, in the window and between the clip spheres
};

// What a place of the picture sees.
struct ViewRay
{
  vec3 Origin;    // view coordinates
  vec3 Direction; // unit length
  bool Inside;    // the map has a direction here
};

// A view is two functions: forward and ray. Everything asks only these.
class WFV_EXPORT View
{
public:
  // Options must have passed CheckOptions.
  View(const Projection& projection, const ViewOptions& options);

  // Point in view coordinates to NDC. The eye itself goes to the centre, not inside.
  NdcPoint Forward(vec3 point) const;

  // NDC to a ray in view coordinates. Never NaN. Where the stereo model's rays are no straight
  // lines: the one through what is seen there on the plane of zero parallax.
  ViewRay Ray(vec2 ndc) const;

  // The ray through what is seen there at the depth ndc.z, at the distance of that depth from
  // its origin: Forward's inverse for every model.
  ViewRay RayAt(vec3 ndc) const;

  // What it was made with.
  const Projection& GetProjection() const { return *this->Map; }

  // nullptr: no stereo.
  const StereoModel* GetStereoModel() const { return this->Stereo; }

  // The numbers that the functions of the projection are called with.
  const WfvView& GetParameters() const { return this->Parameters; }

private:
  const Projection* Map;
  const StereoModel* Stereo;
  std::shared_ptr<const DirectionMap> Tables; // what Parameters point to
  vec2 Center;
  WfvView Parameters;
};
}

#endif
