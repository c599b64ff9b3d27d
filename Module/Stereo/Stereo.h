// SPDX-License-Identifier: BSD-3-Clause
// The registry of stereo models: pure mathematics, no VTK. Everything that offers, draws,
// checks or documents a model reads it from here.
#ifndef WideFoVStereo_h
#define WideFoVStereo_h

#include "Projections/Projection.h"

#include <string>
#include <vector>

namespace wfv
{
// Fraction of the picture's width: a larger separation leaves the eyes nothing in common.
constexpr double MostSeparation = 0.5;

// NDC: eyes farther apart see the cube from beside it.
constexpr double MostIod = 10;

// mono, which is no stereo, then the others.
WFV_EXPORT const std::vector<StereoModel>& StereoModels();

// The model of that name, or nullptr.
WFV_EXPORT const StereoModel* FindStereoModel(const std::string& name);

// The one that is no stereo.
WFV_EXPORT const StereoModel& NoStereo();

// The one to take for two eyes where nobody names any.
WFV_EXPORT const StereoModel& UsualStereo(const Projection& projection);

// The first that has this number.
WFV_EXPORT const StereoModel& StereoWith(StereoNumber number);

// Returns the angle by which an eye turns its picture about the vertical, radians, positive to the
// right. The turn gives points at the level distance CircleConvergence zero parallax. 0 without
// one.
WFV_EXPORT double EyeTurn(const StereoOptions& options);
}

#endif
