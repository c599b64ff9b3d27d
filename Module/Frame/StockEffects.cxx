// SPDX-License-Identifier: BSD-3-Clause
#include "Frame/StockEffects.h"

#include "Compat/Reports.h"

#include "vtkRenderer.h"

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
  const bool on = flag ? true : false;
  flag = 0;
  if (on && wfv::IsNews(std::string("effect ") + name))
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
