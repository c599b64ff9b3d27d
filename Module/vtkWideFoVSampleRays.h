// SPDX-License-Identifier: BSD-3-Clause
// In which direction each pixel of a picture sees.
#ifndef vtkWideFoVSampleRays_h
#define vtkWideFoVSampleRays_h

#include "vtkWideFoVTriangleJudge.h"

#include "vtkSMPTools.h"

#include <vector>

namespace wfv
{
// By the centres of pixels, rounded to float32: for many questions about one picture.
class SampleRays
{
public:
  void Make(const SortView& view)
  {
    const vec2 size = view.Samples.GetSize();
    this->Width = static_cast<std::size_t>(size.x);
    this->Directions.resize(this->Width * static_cast<std::size_t>(size.y));
    vtkSMPTools::For(0, static_cast<vtkIdType>(size.y), [&](vtkIdType from, vtkIdType to) {
      for (std::size_t i = from * this->Width; i < to * this->Width; i++)
      {
        const vec2 at = view.Samples.SampleAt(static_cast<unsigned int>(i));
        const WfvRay ray = view.Map->Unproject(view.Samples.NdcAt(at), view.View);
        this->Directions[i] = ray.inside ? Single(ray.direction) : Single(0);
      }
    });
  }

  bool IsEmpty() const { return this->Directions.empty(); }
  void Clear() { this->Directions = std::vector<Single>(); }

  // Not of unit length outside the map: 0.
  vec3 GetDirection(int x, int y) const
  {
    return vec3(this->Directions[static_cast<std::size_t>(y) * this->Width + x]);
  }

private:
  using Single = glm::vec<3, float, glm::defaultp>;
  std::size_t Width = 0;
  std::vector<Single> Directions;
};
}

#endif
