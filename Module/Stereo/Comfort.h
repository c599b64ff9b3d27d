// SPDX-License-Identifier: BSD-3-Clause
// How far apart the pictures of the two eyes are, and how far apart they may be. Parallax is
// positive for what lies behind the screen. Distances are in one unit of the caller's choice,
// angles in degrees. Sources: the stereo models; S. Gateau and S. Nash, Implementing
// Stereoscopic 3D in Your Applications (the budget); Oculus, Best Practices: Vision (how near
// things may come to eyes in a headset).
#ifndef WideFoVComfort_h
#define WideFoVComfort_h

#include "Projections/Projection.h"

#include <array>
#include <vector>

namespace wfv
{
// Of eyes before a flat picture: parallax of a point at the distance w > 0 ahead, per cent of the
// picture's width.
WFV_EXPORT double Parallax(double separation, double convergence, double w);

// Of eyes on a circle: the angle between the two longitudes at which a point at the horizontal
// distance d is seen, degrees; 180 from inside the circle.
WFV_EXPORT double CircleDisparity(double interpupillaryDistance, double d);

// The angle that a parallax (per cent of the width) is seen under on a screen of this width from
// this distance, degrees.
WFV_EXPORT double ParallaxAngle(double percent, double screenWidth, double viewerDistance);

// The distance between the eyes for a picture whose nearest content is so far away: then it seems
// 0.75 m from people's eyes, which are 0.065 m apart.
WFV_EXPORT double ComfortableEyeDistance(double nearest);

// The largest disparity that is comfortable to look at for long, degrees: that of content which
// seems 0.5 m away.
WFV_EXPORT double LargestDisparity();

// Distances between which content belongs: half the convergence and a hundred times it.
WFV_EXPORT std::array<double, 2> DepthBudget(double convergence);

// The convergence for a picture of such distances: their median, within the budget of what is
// seen: at most twice the nearest, and at least a hundredth of the farthest; where both cannot be
// the nearest counts. A hundredth of the picture at either end does not. 0 where there are none.
WFV_EXPORT double ConvergenceFor(std::vector<double> distances);

// The value that so large a part of the others is below, 0 to 1; 0 where there are none.
WFV_EXPORT double Quantile(std::vector<double>& values, double part);

// The largest separation (fraction of the width) with which nobody's eyes have to diverge on a
// screen of this width: the distance between the eyes over the width, at most 0.5.
WFV_EXPORT double LargestSeparation(double screenWidth, double eyeDistance);
}

#endif
