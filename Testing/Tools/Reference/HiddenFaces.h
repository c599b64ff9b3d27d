// SPDX-License-Identifier: BSD-3-Clause
// What the technique `auto` may show where the ray caster sees it nowhere near: a face that runs
// through the place and is hidden there, beside a silhouette or where surfaces cross, in few
// pixels.
#ifndef WideFoVHiddenFaces_h
#define WideFoVHiddenFaces_h

#include "Projections/Bounds/ChordLimits.h"
#include "Metrics.h"
#include "RayCaster.h"

namespace wfv
{
namespace reference
{
// Relative: by so much a distance may be off that is interpolated between corners which are no
// farther from one another than the longest chord, L radians. Along a plane, over the angle t from
// its normal, it is d / cos(t), of which the second derivative is r (1 + 2 tan(t)^2); an edge of
// the length e looks e cos(t) / r long. So twice the square of L is what it bends by at the most,
// and between three corners at most a sixth of that is missed.
constexpr double ChordDepth = ChordLimits::LongestChord * ChordLimits::LongestChord / 3;

// Of the pixels: what stock VTK shows of hidden faces beside silhouettes, in its own perspective.
constexpr double HiddenShare = 2e-4;

// Whether the cell that was drawn there is seen within so many pixels of the pixel's centre: by
// many more places than the 48 that explain most, which step over thin corners of cells, and by the
// cell's own picture.
bool IsSeenWithin(
  const RayCaster& caster, int width, int height, const WorstPixel& pixel, double tolerance);

// Whether it is seen so near, or would be, were nothing before it.
bool IsThere(
  const RayCaster& caster, int width, int height, const WorstPixel& pixel, double tolerance);

// Whether a border or a silhouette of what is seen passes within so many pixels of the pixel's
// centre, along both axes: elsewhere a hidden face shows through a crack.
bool IsBesideRim(
  const RayCaster& caster, int width, int height, const WorstPixel& pixel, double tolerance);

// Whether the drawn cell is behind what is seen there by so little that depth which is interpolated
// along chords does not tell: where surfaces cross. By the distance at which the pixel's ray meets
// it, or, where the ray passes it, by the distance that was drawn.
bool IsHardlyHidden(const RayCaster& caster, int width, int height, const WorstPixel& pixel);

// Whether `auto` may show there what was drawn: what is seen so near, or a face that is hidden
// there beside a rim or by next to nothing.
bool MayShow(
  const RayCaster& caster, int width, int height, const WorstPixel& pixel, double tolerance);

// Of the worst pixels of a picture that was compared, those that show what is seen nowhere so near.
// As many as Metrics::MaxWorst may be more.
long CountOff(const RayCaster& caster, int width, int height, const Metrics& m, double tolerance);
}
}

#endif
