// SPDX-License-Identifier: BSD-3-Clause
// What the technique `auto` promises of its pictures.
#ifndef WideFoVTestPromise_h
#define WideFoVTestPromise_h

#include "Drawing.h"

#include "HiddenFaces.h"
#include "RayCaster.h"

namespace wfv
{
namespace test
{
// Deviations that a count may be more than its mean: which pixels are so unlucky is chance, so
// their number varies by the square root of what it is in the mean, and by three times that in one
// of several hundred pictures.
constexpr double MostDeviations = 3;

// Of so many pixels, that may be off where this share of them is in the mean.
long MostOff(double share, long pixels);

// Asserts what `auto` promises of such a picture at its tolerance. share: of the pixels, that may
// be off in the mean.
void ExpectPromise(const reference::RayCaster& caster, const Shot& shot,
  const reference::Metrics& m, double tolerance, const std::string& scene,
  double share = reference::HiddenShare);

// Asserts of the worst pixels that each shows a face which runs through its place, no farther from
// it than the tolerance (pixels), seen or hidden there beside a silhouette or where surfaces cross.
void ExpectFacesThatAreThere(const reference::RayCaster& caster, const Shot& shot,
  const reference::Metrics& m, double tolerance, const std::string& scene);

// Asserts that no pixel of the drawing's last picture is off by more than the tolerance (pixels),
// but for so few that show a face which runs through their place and is hidden there beside a
// silhouette or where surfaces cross. Prints a row.
void ExpectPromise(const Drawing& drawing, const Shot& shot, const reference::DrawnPicture& picture,
  double tolerance, const std::string& scene);
}
}

#endif
