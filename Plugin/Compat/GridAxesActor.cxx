// SPDX-License-Identifier: BSD-3-Clause
#include "GridAxesActor.h"

#include "vtkAxis.h"
#include "vtkDoubleArray.h"
#include "vtkPVVersion.h"
#include "vtkStringArray.h"

namespace wfvplugin
{
namespace
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 5, 0)
// Private since VTK 9.5, with getters since 9.7. An explicit instantiation may name what is
// private.
template <auto Used, auto Labels>
struct Opener
{
  friend vtkDoubleArray* OpenCustomLabels(GridAxesActor* actor, int axis)
  {
    return (actor->*Used)[axis] ? (actor->*Labels)[axis].Get() : nullptr;
  }
};
vtkDoubleArray* OpenCustomLabels(GridAxesActor* actor, int axis);
template struct Opener<&GridAxesActor::UseCustomLabels, &GridAxesActor::CustomLabels>;
#else
class GridAccess : public GridAxesActor
{
public:
  static vtkDoubleArray* GetCustomLabels(GridAxesActor* actor, int axis)
  {
    const bool used = (actor->*(&GridAccess::UseCustomLabels))[axis];
    return used ? (actor->*(&GridAccess::CustomLabels))[axis].Get() : nullptr;
  }
};
#endif
}

vtkDoubleArray* GetCustomLabels(GridAxesActor* actor, int axis)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 5, 0)
  return OpenCustomLabels(actor, axis);
#else
  return GridAccess::GetCustomLabels(actor, axis);
#endif
}

std::string GetTickText(GridAxesActor* actor, int axis, vtkAxis* numbers, vtkIdType tick)
{
  const std::string text = numbers->GetTickLabels()->GetValue(tick);
#if PARAVIEW_VERSION_NUMBER >= PARAVIEW_VERSION_CHECK(5, 12, 0)
  if (const auto before = actor->GetTickLabelFunction(axis); before && !text.empty())
  {
    return numbers->GenerateSimpleLabel(before(numbers->GetTickPositions()->GetValue(tick)));
  }
#else
  (void)actor;
  (void)axis;
#endif
  return text;
}
}
