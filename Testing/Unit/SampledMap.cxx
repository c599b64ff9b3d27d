// SPDX-License-Identifier: BSD-3-Clause
#include "SampledMap.h"

#include "Projections/DirectionMap/DirectionTables.h"

namespace wfv
{
namespace test
{
bool Boxes::Hold(const vec2& ndc) const
{
  const auto in = [&](const vec4& r) {
    return ndc.x >= r.x && ndc.x <= r.z && ndc.y >= r.y && ndc.y <= r.w;
  };
  return in(this->First) || in(this->Second);
}

std::optional<Piece> PieceOf(const vec3& centre, double angle, const WfvView& view)
{
  const tables::WfvPlaces places = tables::wfvCapPlaces(centre, angle, view);
  return places.curvature < 1 ? std::optional<Piece>({ places.first, places.curvature })
                              : std::nullopt;
}

vec3 PlaceIn(const vec4& r, const vec3& direction, const WfvView& view)
{
  const vec2 middle = tables::wfvPixelOfNdc(0.5 * vec2(r.x + r.z, r.y + r.w), view);
  return tables::wfvFindFrom(middle, direction, view);
}

double BesideChord(double chord, double curvature)
{
  return tables::wfvBesideChord(chord, curvature);
}

Boxes CapBoxes(const vec3& centre, double angle, const WfvView& view)
{
  const tables::WfvPlaces places = tables::wfvCapPlaces(centre, angle, view);
  return { places.first, places.second };
}
}
}
