// SPDX-License-Identifier: BSD-3-Clause
// What asks for the corners of a rectangle of the picture, near and far, to select what is between
// the planes through them: vtkAreaPicker, and what makes a frustum as it does. In a wide view the
// sides of a rectangle are curves.
#ifndef WideFoVAreaQuestions_h
#define WideFoVAreaQuestions_h

#include "Projections/ProjectionMath.h"
#include "vtkWideFoVAbi.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkWideFoVCamera;
VTK_ABI_NAMESPACE_END

namespace wfv
{
class AreaQuestions
{
public:
  // A place of the picture (NDC) that is asked for, at a depth from 0 to 1. True where it is the
  // eighth of a rectangle.
  bool Ask(const vec2& place, double depth);

  // Whether planes through the corners of that rectangle hold what is seen in it, to a pixel (NDC).
  bool IsBetweenPlanes(vtkWideFoVCamera* camera, double aspect, const vec2& pixel) const;

  // Whether something is still to be said of it: not where a selector draws it next.
  bool Pending = false;

private:
  int Count = 0; // of the questions so far
  vec2 First{ 0 };
  vec2 Last{ 0 };
};
}

#endif
