// SPDX-License-Identifier: BSD-3-Clause
// How long edges may look for their chords to stand for them.
#ifndef WideFoVChordLimits_h
#define WideFoVChordLimits_h

#include "Projections/Bounds/LocalCurvature.h"

#include <vector>

namespace wfv
{
// For each cell of directions (wfv::LocalCurvature) the largest angle that an edge there may have
// so that its chord error, the distance between the edge and its chord in the picture, is within a
// tolerance. One number a cell: to classify an edge is to look up two of them.
class WFV_EXPORT ChordLimits
{
public:
  // Radians: no chord is longer, whatever the map. Depth and attributes are interpolated
  // along chords; a distance is then off by a third of the squared angle at the most.
  static constexpr double LongestChord = 0.08;

  // pixels: of the whole picture; tolerance: pixels.
  ChordLimits(const Projection& projection, const WfvView& view, const LocalCurvature& table,
    const vec2& pixels, double tolerance);

  // Squared radians, 0 where no edge may. direction: of any length but 0, in the map's own frame,
  // of any point of the edge.
  float At(const vec3& direction) const
  {
    if (this->IsBesideSingularity(direction))
    {
      return 0;
    }
    const float limit = this->Limits[LocalCurvature::CellOf(direction)];
    return limit < Coarse ? std::max(limit, this->NearSingularity(direction)) : limit;
  }

  // The least of all directions that are no farther from this one than an angle whose sine this is;
  // 0 where the angle is too large to say.
  float LeastAround(const vec3& direction, double sine) const;

  // Pixels a radian, by which the map stretches there at the most.
  float StretchAt(const vec3& direction) const
  {
    return this->Stretches[LocalCurvature::CellOf(direction)];
  }

  // The most of all directions that are no farther from this one than an angle whose sine this is;
  // infinite where the angle is too large to say.
  float MostStretchAround(const vec3& direction, double sine) const;

  // True if a direction, or one that an angle of this sine leads to from there, is so near a pole
  // or an antipode that the map curves from pixel to pixel. direction: of any length but 0.
  bool IsBesideSingularity(const vec3& direction, double sine = 0) const
  {
    const vec3& d = direction;
    const double beside = this->BesideSine + sine;
    const double level = this->Axis == Family::Meridian ? d.z : d.y;
    const bool ahead = this->Axis == Family::Azimuthal && d.z <= 0;
    return this->BesideSine > 0 && !ahead &&
      d.x * d.x + level * level < beside * beside * glm::dot(d, d);
  }

private:
  // Squared radians: beside a pole or an antipode a cell has as little as this, if any, for all
  // that is in it, though most is farther from there than its nearest place.
  static constexpr float Coarse = 0.02f * 0.02f;

  // By the bound of wfv::Curvature, which knows how near a direction is.
  // aside: the sine of an angle to go nearer.
  float NearSingularity(const vec3& direction, double aside = 0) const;

  void SpreadLimits();            // to Least and MostStretches
  static int RingOf(double sine); // Rings where none is so wide

  Family Axis;
  double BesideSine; // of IsBesideSingularity
  double PerSine2;   // squared radians over the squared sine of the angle from there; 0: no bound
  static constexpr int Rings = 4; // a table of the least round each cell, of 1, 2, 4, .. cells

  std::vector<float> Limits;
  std::vector<float> Least[Rings];
  std::vector<float> Stretches;
  std::vector<float> MostStretches[Rings];
};
}

#endif
