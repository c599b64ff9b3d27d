// SPDX-License-Identifier: BSD-3-Clause
#include "Frame/StockEffects.h"

#include "vtkRenderer.h"

#include <mutex>
#include <set>
#include <string>

namespace
{
class Access : public vtkRenderer
{
public:
  static auto& Shadows(vtkRenderer* renderer) { return renderer->*(&Access::UseShadows); }
  static auto& Occlusion(vtkRenderer* renderer) { return renderer->*(&Access::UseSSAO); }
};

// Switches one off; returns whether it was on. Warns once a process.
template <typename Switch>
bool TakeOff(vtkRenderer* renderer, Switch& flag, const char* name)
{
  static std::mutex lock;
  static std::set<std::string> said;
  const bool on = flag ? true : false;
  flag = 0;
  const std::lock_guard<std::mutex> guard(lock);
  if (on && said.insert(name).second)
  {
    vtkWarningWithObjectMacro(
      renderer, << name << " is left out in a wide view: it takes the picture for a perspective");
  }
  return on;
}
}

namespace wfv
{
WithoutStockEffects::WithoutStockEffects(vtkRenderer* renderer)
  : Renderer(renderer)
  , Shadows(TakeOff(renderer, Access::Shadows(renderer), "UseShadows"))
  , Occlusion(TakeOff(renderer, Access::Occlusion(renderer), "UseSSAO"))
{
}

WithoutStockEffects::~WithoutStockEffects()
{
  Access::Shadows(this->Renderer) = this->Shadows;
  Access::Occlusion(this->Renderer) = this->Occlusion;
}
}
