// SPDX-License-Identifier: BSD-3-Clause
#include "SampledShot.h"

#include "SampledView.h"

namespace wfv
{
namespace test
{
void UseMapOf(const std::string& projection, Shot& shot)
{
  const Projection& p = *FindProjection(projection);
  ViewOptions o;
  o.HorizontalFov = p.MaxHorizontalFov;
  o.VerticalFov = p.MaxVerticalFov;
  o.Aspect = double(shot.Width) / shot.Height;
  shot.Projection = SampledProjection().Name;
  shot.Options.Map = reference::SampleView(View(p, o), shot.Width, shot.Height);
}
}
}
