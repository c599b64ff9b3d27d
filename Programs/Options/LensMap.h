// SPDX-License-Identifier: BSD-3-Clause
// Lenses whose map is not round, as direction maps: Brown-Conrady with decentering (p1, p2) and
// with OpenCV's rational coefficients (k4, k5, k6).
#ifndef WideFoVLensMap_h
#define WideFoVLensMap_h

#include "LensFile.h"
#include "Projections/DirectionMap.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace widefov
{
// Whether a Brown-Conrady lens has such coefficients.
bool IsUneven(const CalibratedLens& lens);

// Pixels, divided by the focal lengths, from the axis to the farthest corner of a picture.
double RadiusToCorners(const wfv::MeasuredPicture& picture);

// How far a lens is followed from its axis.
struct LensReach
{
  double Most;   // radians
  double Corner; // the radius that it must have grown to
  double End;    // that at which it need go no farther
};

// The angle from the axis, radians, at which a radius is no less than reach.End, or stops growing.
// Throws a Failure with ExitUsage where that is before reach.Corner; file: what the lens is of.
double FollowLens(const std::string& file, const LensReach& reach,
  const std::function<double(double angle)>& radiusAt);

// Up to where this lens is drawn: the tangent of the angle from its axis at which it reaches the
// corners of its picture, or of half the field of view, degrees. Throws as FollowLens.
double EndOfLens(
  const std::string& file, const CalibratedLens& lens, const std::optional<double>& fov);

// The directions of a picture of this size, which shows that of the lens as large as it fits.
std::shared_ptr<const wfv::DirectionMap> MakeLensMap(
  const CalibratedLens& lens, int width, int height);
}

#endif
