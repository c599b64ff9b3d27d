// SPDX-License-Identifier: BSD-3-Clause
#include "PolarAxesParts.h"

#include "vtkAxisActor.h"
#include "vtkAxisFollower.h"
#include "vtkMathUtilities.h"
#include "vtkPolarAxesActor.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"
#include "vtkVersionMacros.h"

namespace wfvplugin
{
namespace
{
class PolarAccess : public vtkPolarAxesActor
{
public:
  static void Build(vtkPolarAxesActor* stock, vtkRenderer* renderer)
  {
    (stock->*(&PolarAccess::BuildAxes))(renderer);
  }

#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 5, 0)
  static vtkAxisActor* GetPolar(vtkPolarAxesActor* stock)
  {
    vtkAxisActor* const axis = stock->*(&PolarAccess::PolarAxis); // a vtkNew since 9.3
    return stock->GetPolarAxisVisibility() ? axis : nullptr;
  }
  static std::vector<vtkAxisActor*> GetRadial(vtkPolarAxesActor* stock)
  {
    std::vector<vtkAxisActor*> axes;
    const int count = stock->*(&PolarAccess::NumberOfRadialAxes);
    const bool round =
      vtkMathUtilities::FuzzyCompare(stock->GetMaximumAngle(), stock->GetMinimumAngle());
    for (int i = 0; stock->GetRadialAxesVisibility() && i < count; i++)
    {
      const bool inner = i != count - 1 || round;
      if (!inner || stock->GetDrawRadialGridlines())
      {
        axes.push_back((stock->*(&PolarAccess::RadialAxes))[i]);
      }
    }
    return axes;
  }
  static std::vector<vtkActor*> GetArcs(vtkPolarAxesActor* stock)
  {
    std::vector<vtkActor*> arcs;
    if (!stock->GetPolarArcsVisibility())
    {
      return arcs;
    }
    arcs.push_back(stock->*(&PolarAccess::PolarArcsActor));
    arcs.push_back(stock->*(&PolarAccess::SecondaryPolarArcsActor));
    if (stock->GetPolarTickVisibility() && stock->GetArcTickVisibility())
    {
      arcs.push_back(stock->*(&PolarAccess::ArcTickActor));
    }
    if (stock->GetPolarTickVisibility() && stock->GetArcMinorTickVisibility())
    {
      arcs.push_back(stock->*(&PolarAccess::ArcMinorTickActor));
    }
    return arcs;
  }
#endif
};

#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 5, 0)
// The polar axis, where it is drawn, is the first of them.
PolarAxesParts List(vtkPolarAxesActor* stock)
{
  PolarAxesParts parts;
  vtkNew<vtkPropCollection> drawn;
  stock->GetRendered3DProps(drawn, false);
  vtkCollectionSimpleIterator it;
  drawn->InitTraversal(it);
  while (vtkProp* const prop = drawn->GetNextProp(it))
  {
    auto* const axis = vtkAxisActor::SafeDownCast(prop);
    if (axis && stock->GetPolarAxisVisibility() && !parts.Polar)
    {
      parts.Polar = axis;
    }
    else if (axis)
    {
      parts.Radial.push_back(axis);
    }
    else if (auto* const arc = vtkActor::SafeDownCast(prop))
    {
      parts.Arcs.push_back(arc);
    }
  }
  return parts;
}
#else
PolarAxesParts List(vtkPolarAxesActor* stock)
{
  return { PolarAccess::GetPolar(stock), PolarAccess::GetRadial(stock),
    PolarAccess::GetArcs(stock) };
}
#endif
}

PolarAxesParts BuildPolarAxes(vtkPolarAxesActor* stock, vtkRenderer* renderer)
{
  PolarAccess::Build(stock, renderer);
  PolarAxesParts parts = List(stock);
  for (vtkAxisActor* const axis : parts.Radial)
  {
    axis->BuildAxis(renderer, false);
  }
  return parts;
}

vtkAxisFollower* GetLetters(vtkAxisActor* axis, int i)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 5, 0)
  return axis->GetLabelFollower(i);
#else
  return axis->GetLabelActors()[i];
#endif
}
}
