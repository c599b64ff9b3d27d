// SPDX-License-Identifier: BSD-3-Clause
// Balls, sticks and hulls as VTK's mappers draw them, and the same for the ray caster.
#ifndef WideFoVTestBodies_h
#define WideFoVTestBodies_h

#include "Drawing.h"
#include "RayQuadric.h"

#include <vtkActor.h>
#include <vtkSmartPointer.h>

#include <vector>

namespace wfv
{
namespace test
{
// World coordinates; all of one shape.
using BodyList = std::vector<reference::Body>;

reference::Body Ball(const vec3& centre, double radius);
reference::Body Stick(const vec3& from, const vec3& to, double radius);
reference::Body Segment(const vec3& from, const vec3& to); // radii follow from the view

// Round the eye at the origin: at each of the places where a map is torn or stretched, in
// sizes from under a pixel to half the sky; seeded ones between. One holds the eye if
// `outer`, with everything else inside it.
BodyList BallsRoundTheEye(bool outer);
BodyList SticksRoundTheEye();
BodyList SegmentsRoundTheEye();
BodyList PointsRoundTheEye();

// The stock sphere or stick mapper.
vtkSmartPointer<vtkActor> BallActor(const BodyList& balls);
vtkSmartPointer<vtkActor> StickActor(const BodyList& sticks);

// The stock polydata mapper: lines as tubes, points as spheres, so many pixels wide.
vtkSmartPointer<vtkActor> TubeActor(const BodyList& segments, double pixels);
vtkSmartPointer<vtkActor> PointActor(const BodyList& points, double pixels);

// In view coordinates, rounded as the vertex buffer rounds them. Where `pixels` is not 0,
// radii are those of so many pixels.
BodyList InView(const BodyList& bodies, const reference::Pose& pose, const View& view,
  double pixels, int width, int height);
}
}

#endif
