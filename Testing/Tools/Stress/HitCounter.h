// SPDX-License-Identifier: BSD-3-Clause
// How often each pixel is hit: additive blending without depth test.
#ifndef WideFoVStressHitCounter_h
#define WideFoVStressHitCounter_h

#include "vtkWideFoVAbi.h"

#include "Drawing.h"

#include <memory>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkPolyData;
VTK_ABI_NAMESPACE_END

namespace wfv
{
namespace stress
{
class HitCounter
{
public:
  HitCounter();
  ~HitCounter();

  // Of each pixel, rows from the top; 255 stands for that many or more. Empty where the
  // window failed.
  std::vector<unsigned char> Count(
    vtkPolyData* mesh, const test::Shot& shot, int technique, double tolerance);

private:
  struct Internals;
  std::unique_ptr<Internals> Internal;
};
}
}

#endif
