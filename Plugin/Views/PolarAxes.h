// SPDX-License-Identifier: BSD-3-Clause
// ParaView's polar axes, drawn where a wide view shows them.
#ifndef WideFoVPluginPolarAxes_h
#define WideFoVPluginPolarAxes_h

#include "PlacedLabels.h"
#include "StandIn.h"

#include "vtkSmartPointer.h"

#include <array>
#include <vector>

class vtkActor;
class vtkAxisActor;
class vtkPolarAxesActor;

namespace wfvplugin
{
// The stock actor's lines are right, but the pass does not reach them, for it is told of the whole
// alone; its letters are surfaces that turn to the plane of a flat picture. This one hands over the
// same lines, and billboards beside the places that the texts belong to.
class PolarAxes : public StandIn
{
public:
  explicit PolarAxes(vtkPolarAxesActor* stock);
  ~PolarAxes() override;

  vtkProp* GetStock() const override;
  void Show(vtkRenderer* renderer) override;
  void Hide() override;

private:
  struct Axis
  {
    vtkSmartPointer<vtkAxisActor> Actor;
    std::array<int, 3> Texts; // whether its title, its numbers and its exponent are shown
  };

  void KeepAxes(const std::vector<vtkAxisActor*>& wanted);
  void AddTexts(vtkAxisActor* axis, bool polar, int titleLocation);
  void AddNumbers(vtkAxisActor* axis);
  PlacedLabel MakeLabel(
    vtkAxisActor* axis, double share, const std::string& text, double distance, bool atEnd);
  void ShowArcs(const std::vector<vtkActor*>& arcs);

  vtkPolarAxesActor* Stock;
  vtkSmartPointer<vtkRenderer> Renderer;        // which the lines are in
  std::vector<Axis> Axes;                       // of the stock actor, that are drawn
  std::vector<vtkSmartPointer<vtkActor>> Lines; // the arcs and their marks; as many as ever
  std::vector<PlacedLabel> Labels;
  PlacedLabels Texts;
};
}

#endif
