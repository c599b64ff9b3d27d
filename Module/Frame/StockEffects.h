// SPDX-License-Identifier: BSD-3-Clause
// What stock renderers add to a picture, and a wide view cannot have yet.
#ifndef WideFoVStockEffects_h
#define WideFoVStockEffects_h

#include "vtkWideFoVAbi.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkRenderer;
VTK_ABI_NAMESPACE_END

namespace wfv
{
// For as long as this lives, shadows and ambient occlusion are off, which reckon in a perspective:
// with one warning each. The renderer does not count as modified.
class WithoutStockEffects
{
public:
  explicit WithoutStockEffects(vtkRenderer* renderer);
  ~WithoutStockEffects();
  WithoutStockEffects(const WithoutStockEffects&) = delete;
  WithoutStockEffects& operator=(const WithoutStockEffects&) = delete;

private:
  vtkRenderer* Renderer;
  bool Shadows;
  bool Occlusion;
};
}

#endif
