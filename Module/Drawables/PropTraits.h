// SPDX-License-Identifier: BSD-3-Clause
// What is known of a prop whatever the view.
#ifndef WideFoVPropTraits_h
#define WideFoVPropTraits_h

#include "vtkWideFoVAbi.h"

#include "vtkType.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkActor;
VTK_ABI_NAMESPACE_END

namespace wfv
{
// Shaders of a user's own may move vertices anywhere.
bool HasOwnShaders(vtkActor* actor);

struct PropTraits
{
  bool Known = false;
  bool Prepared = false;    // its buffer
  bool Bounded = false;     // its bounds hold what it draws, but for its footprint
  bool Uncountable = false; // for OpenGL or VTK (IndexLimit.h): it is not drawn
  double Footprint = 0;     // by which its lines and points may be wider than they are, pixels
  double PointSize = 1;     // pixels
  vtkIdType Few = 0;        // cells, where too few to classify; 0: not few
  double LongestEdge = -1;  // scene units; negative: not asked for yet
};
}

#endif
