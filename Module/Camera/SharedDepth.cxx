// SPDX-License-Identifier: BSD-3-Clause
#include "Camera/SharedDepth.h"

#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkRendererCollection.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace
{
// When a renderer is drawn in its window: layer by layer, in each as they were added.
using Turn = std::pair<int, int>;

bool Overlaps(vtkRenderer* one, vtkRenderer* other)
{
  const double* const a = one->GetViewport();
  const double* const b = other->GetViewport();
  return a[0] < b[2] && b[0] < a[2] && a[1] < b[3] && b[1] < a[3];
}

template <typename F>
void ForEachDrawn(vtkRenderer* renderer, const F& call)
{
  vtkRendererCollection* const all = renderer->GetRenderWindow()->GetRenderers();
  vtkCollectionSimpleIterator it;
  all->InitTraversal(it);
  int number = 0;
  while (vtkRenderer* const each = all->GetNextRenderer(it))
  {
    const Turn turn(each->GetLayer(), number++);
    if (each == renderer || (each->GetDraw() && Overlaps(each, renderer)))
    {
      call(each, turn);
    }
  }
}
}

namespace wfv
{
void FindRenderersOfDepth(vtkRenderer* renderer, std::vector<vtkRenderer*>& found)
{
  found.clear();
  vtkRenderWindow* const window = renderer->GetRenderWindow();
  if (!window || !window->GetRenderers()->IsItemPresent(renderer))
  {
    found.push_back(renderer);
    return;
  }
  Turn own;
  ForEachDrawn(
    renderer, [&](vtkRenderer* each, const Turn& turn) { own = each == renderer ? turn : own; });
  Turn begin(std::numeric_limits<int>::min(), 0); // depth was last cleared before it
  Turn end(std::numeric_limits<int>::max(), 0);   // and is cleared next
  ForEachDrawn(renderer, [&](vtkRenderer* each, const Turn& turn) {
    if (!each->GetPreserveDepthBuffer())
    {
      begin = turn <= own ? std::max(begin, turn) : begin;
      end = turn > own ? std::min(end, turn) : end;
    }
  });
  ForEachDrawn(renderer, [&](vtkRenderer* each, const Turn& turn) {
    if (begin <= turn && turn < end)
    {
      found.push_back(each);
    }
  });
}
}
