// SPDX-License-Identifier: BSD-3-Clause
// One scene for each kind of thing that VTK draws with shaders of its own, which together have
// every text that is edited.
#ifndef StockEditScenes_h
#define StockEditScenes_h

#include "WideFoVTestScene.h"

#include <functional>
#include <string>
#include <vector>

namespace stockScenes
{
struct Scene
{
  std::string Name;
  std::function<void(WideFoVTestWindow&)> Fill;

  // Of a flat camera: what is not edited is drawn as VTK draws it.
  bool Flat = false;
};

const std::vector<Scene>& All();
}

#endif
