// SPDX-License-Identifier: BSD-3-Clause
// Which array gives the colours of a scene.
#ifndef WideFoVColorChoice_h
#define WideFoVColorChoice_h

#include "Scene.h"

#include <string>

namespace widefov
{
// Chooses the arrays, the ranges and the maps of the props. Throws a Failure with ExitFailed if the
// data lack the array of --color-by.
void ChooseColors(Scene& scene, const Look& look);

// Notes that the data have no array of that name. Throws a Failure with ExitFailed unless the scene
// is one time step of several.
void LackArray(Scene& scene, const Look& look, const std::string& option, const std::string& name);
}

#endif
