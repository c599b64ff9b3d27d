// SPDX-License-Identifier: BSD-3-Clause
// What is known of a prop whatever the view.
#ifndef vtkWideFoVPropFacts_h
#define vtkWideFoVPropFacts_h

namespace wfv
{
struct PropFacts
{
  bool Known = false;
  bool Prepared = false;   // its buffer
  bool Bounded = false;    // its bounds hold what it draws, but for the widths
  double Width = 0;        // of its lines or points, pixels
  double PointSize = 1;    // pixels
  double LongestEdge = -1; // scene units; negative: not asked for yet
};
}

#endif
