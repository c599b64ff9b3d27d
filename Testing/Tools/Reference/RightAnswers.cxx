// SPDX-License-Identifier: BSD-3-Clause
#include "RightAnswers.h"

#include "Witness.h"

namespace wfv
{
namespace reference
{
bool IsRightAnswer(const Caster& caster, vec2 ndc, vtkIdType cell)
{
  const TriangleSoup* const soup = caster.GetSoup();
  const StereoModel* const model = caster.GetView().GetStereoModel();
  const ViewRay ray = caster.GetView().Ray(ndc);
  if (!soup || !ray.Inside || (model && !model->Traits.StraightRays))
  {
    return false;
  }
  const WitnessRequest request{ ray.Origin, ray.Direction, caster.GetView().GetParameters().radii };
  if (cell < 0)
  {
    // the usual case of what is missing: something is there, and not only by a hair
    const Hit hit = caster.Cast(ndc);
    if (hit.Triangle >= 0 && IsWellInside(*soup, request, std::size_t(hit.Triangle)))
    {
      return false;
    }
  }
  return FindWitness(*soup, request, cell).has_value() ||
    (cell >= 0 && IsBehindEdges(*soup, request, cell));
}
}
}
