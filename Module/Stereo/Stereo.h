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
// mono, which is no stereo, then the others.
WFV_EXPORT const std::vector<StereoModel>& StereoModels();

// The model of that name, or nullptr.
WFV_EXPORT const StereoModel* FindStereoModel(const std::string& name);
}

#endif
