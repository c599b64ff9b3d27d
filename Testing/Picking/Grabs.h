// SPDX-License-Identifier: BSD-3-Clause
// Handles of widgets, grabbed where they are seen, and dragged.
#ifndef WideFoVGrabs_h
#define WideFoVGrabs_h

#include "PickScene.h"

#include <vtkGenericRenderWindowInteractor.h>

#include <array>
#include <random>

namespace wfv
{
namespace test
{
using Place = std::array<double, 3>; // world
using Pixel = std::array<int, 2>;

// A window that shows widgets alone, and a mouse.
class GrabStage
{
public:
  GrabStage(const PickView& view, unsigned int seed);

  // A place in any direction that is seen with what is a unit round it, and far from a seam.
  Place AnyPlace();

  // Where a place is seen.
  Pixel SeenAt(const Place& place);

  // How far from there, pixels.
  double DistanceFrom(const Place& place, const Pixel& pixel);

  // A few pixels away from there, in the picture.
  Pixel Beside(const Pixel& from);

  // Presses the left button, moves in steps, and lets go.
  void Drag(const Pixel& from, const Pixel& to);

  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkWideFoVRenderer> Renderer;
  vtkNew<vtkWideFoVCamera> Camera;
  vtkNew<vtkGenericRenderWindowInteractor> Interactor;

private:
  bool IsNearSeam(const Place& place);

  std::mt19937 Engine;
};

// Each places a widget, drags a handle of it, and says what was wrong; empty where nothing was.
std::string GrabHandle(GrabStage& stage);
std::string GrabEndOfLine(GrabStage& stage);
std::string GrabSphere(GrabStage& stage);
std::string GrabHandleOfSphere(GrabStage& stage);
std::string GrabFaceOfBox(GrabStage& stage);
}
}

#endif
