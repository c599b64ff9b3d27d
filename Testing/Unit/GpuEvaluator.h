// SPDX-License-Identifier: BSD-3-Clause
// Evaluates the projection files on the GPU, for many inputs at once.
#ifndef WideFoVGpuEvaluator_h
#define WideFoVGpuEvaluator_h

#include "Projections/Projection.h"

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace wfv
{
namespace test
{
class GpuEvaluator
{
public:
  using Texel = std::array<float, 4>;

  GpuEvaluator();
  ~GpuEvaluator();

  // For each direction (xyz) and distance (w) the place in NDC (xy) by wfvProject, the depth
  // (z) by wfvDepthOf and the distance (w) that wfvDistanceAt makes of it; for each NDC (xy)
  // the direction (xyz) and 1 or 0 for inside (w) by wfvUnproject; all in float32. Both inputs have
  // Side * Side texels. False where the shader does not compile.
  bool Evaluate(const View& view, const std::vector<Texel>& directions,
    const std::vector<Texel>& ndc, std::vector<Texel>& projected, std::vector<Texel>& unprojected);

  // Width and height of the texture of inputs.
  static constexpr int Side = 1024;

  // GL_RENDERER, for messages.
  std::string GetRenderer() const;

private:
  struct Internals;
  std::unique_ptr<Internals> Internal;
};
}
}

#endif
