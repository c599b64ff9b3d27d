// SPDX-License-Identifier: BSD-3-Clause
// The eyes that the comparison looks from.
#ifndef WideFoVTestPoses_h
#define WideFoVTestPoses_h

#include "Drawing.h"

#include <string>
#include <vector>

namespace wfv
{
namespace test
{
struct NamedPose
{
  std::string Name;
  vec3 Eye{ 0 };
  vec3 Direction{ 0, 0, -1 };
  vec3 Up{ 0, 1, 0 };
};

// The pose turned to the right by `yaw` and then upwards by `pitch`, degrees.
NamedPose Turned(const NamedPose& pose, double yaw, double pitch, const std::string& name);

// For every projection and field of view: from the middle along the axes, where pole and
// seam meet vertices and edges; off the middle, turned to no direction in particular.
std::vector<NamedPose> PlainPoses();

// Poles and seam swept through the vertices of the globe of n cells: on them, 1e-6, 1e-4 and
// 1e-2 degrees beside them, and a quarter of a degree.
std::vector<NamedPose> SweptPoses(int n);

// The eye on a vertex, an edge and a face of the room's wall x = 1 (n cells a side).
std::vector<NamedPose> WallPoses(int n);

// Those of the fields of view, degrees, that are drawn with a projection. The projections
// that came later share their families' shaders: their widest alone, to spare time.
std::vector<double> FovsOf(const Projection& projection, const std::vector<double>& fovs);

// The largest field of view that the techniques draw, degrees: of the perspective's, which is 179,
// a common one.
double WidestDrawn(const Projection& projection);

// A shot of a projection from a pose: size and vertical field of view by the projection.
Shot MakeShot(const std::string& projection, double fov, const NamedPose& pose);
}
}

#endif
