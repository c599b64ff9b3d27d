// SPDX-License-Identifier: BSD-3-Clause
// Bodies all round the eye, drawn and as the ray caster sees them.
#ifndef WideFoVPickScene_h
#define WideFoVPickScene_h

#include "RayCaster.h"

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkRenderWindow.h>
#include <vtkSmartPointer.h>
#include <vtkWideFoVCamera.h>
#include <vtkWideFoVRenderer.h>

#include <memory>
#include <string>
#include <vector>

namespace wfv
{
namespace test
{
// How a picture is made; eye: of a model of two, else Eye::Middle.
struct PickView
{
  std::string Projection;
  Eye Which = Eye::Middle;
  double Tilt = 0; // degrees
};

std::string Describe(const PickView& view);

// A body and one of its cells; neither where nothing is.
struct PickedCell
{
  vtkProp* Prop = nullptr;
  vtkIdType Cell = -1;
  bool operator==(const PickedCell& other) const
  {
    return this->Prop == other.Prop && this->Cell == other.Cell;
  }
};

// Puts the camera into the renderer, which draws exactly, and the window into the eye's mode.
void PlaceCamera(vtkRenderWindow* window, vtkWideFoVRenderer* renderer, vtkWideFoVCamera* camera,
  const PickView& view);

class PickScene
{
public:
  static constexpr int Width = 600;
  static constexpr int Height = 300;

  // Draws the scene.
  explicit PickScene(const PickView& view);

  // What the ray caster sees at a display point, pixels.
  PickedCell See(double x, double y) const;

  // Whether it sees the cell there or within this many pixels of it.
  bool SeesNear(double x, double y, double radius, const PickedCell& cell) const;

  const std::vector<vtkSmartPointer<vtkActor>>& GetBodies() const { return this->Bodies; }

  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkWideFoVRenderer> Renderer;
  vtkNew<vtkWideFoVCamera> Camera;

private:
  void Add(vtkPolyData* mesh);
  void MakeCaster();

  std::vector<vtkSmartPointer<vtkActor>> Bodies;
  std::vector<vtkIdType> FirstCells; // of each, in the caster's numbers
  std::unique_ptr<reference::RayCaster> Caster;
};
}
}

#endif
