// SPDX-License-Identifier: BSD-3-Clause
// An axes grid of ParaView's, drawn where a wide view shows it.
#ifndef WideFoVPluginAxesGrid_h
#define WideFoVPluginAxesGrid_h

#include "GridBox.h"
#include "PlacedLabels.h"
#include "StandIn.h"

#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkType.h" // For vtkMTimeType

#include <array>
#include <string>
#include <vector>

class vtkActor;
class vtkAxis;
class vtkContextScene;
class vtkPolyData;
class vtkRenderer;
class vtkTextProperty;

namespace wfvplugin
{
// ParaView's own takes the picture of a face for a quadrilateral, chooses labels and their sides by
// it, leaves out faces whose first corner is seen at a low angle, and labels no edge of a box that
// surrounds the eye; its labels are inside it, where the pass does not find them. This one has the
// same settings, its lines are lines of the scene and its labels billboards, which the pass draws.
class AxesGrid : public StandIn
{
public:
  explicit AxesGrid(GridAxesActor* stock);
  ~AxesGrid() override;

  vtkProp* GetStock() const override;
  void Show(vtkRenderer* renderer) override;
  void Hide() override;

private:
  struct Ticks
  {
    std::vector<double> Places; // in the grid's coordinates, along the axis
    std::vector<std::string> Texts;
  };

  void Find(vtkRenderer* renderer);
  void FindTicks(vtkRenderer* renderer, const GridBox& box);
  void AddFace(const GridBox& box, const GridFace& face);
  void AddEdge(vtkRenderer* renderer, const GridBox& box, const GridEdge& edge);
  void AddLine(const GridBox& box, const Point3& from, const Point3& to);
  void UpdateLines();

  GridAxesActor* Stock;                  // not owned: it may go
  vtkSmartPointer<vtkRenderer> Renderer; // which the lines are in
  vtkNew<vtkActor> Lines;
  std::vector<Point3> Points; // two a line, world
  std::vector<Point3> Drawn;  // those that the lines are now
  vtkMTimeType PropertyTime = 0;
  std::vector<PlacedLabel> Labels;
  PlacedLabels Texts;
  std::array<vtkNew<vtkAxis>, 3> Axes; // which choose the numbers
  vtkNew<vtkContextScene> Scene;       // that they want to be in
  std::array<Ticks, 3> TicksOf;
};
}

#endif
