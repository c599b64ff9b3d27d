// SPDX-License-Identifier: BSD-3-Clause
// A window beside the viewer's: its picture on a dome, seen from a seat.
#ifndef WideFoVDomeWindow_h
#define WideFoVDomeWindow_h

#include "GlfwRenderWindow.h"
#include "GlfwWindow.h"
#include "ImageOutput.h"
#include "Options.h"

#include <vtkActor.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderer.h>

#include <array>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

namespace widefov
{
// Draws with stock VTK. The seat is behind the middle of the dome; dragging turns the head.
class DomeWindow
{
public:
  // To the right of another window.
  explicit DomeWindow(const GlfwWindow& other);
  ~DomeWindow();
  DomeWindow(const DomeWindow&) = delete;
  DomeWindow& operator=(const DomeWindow&) = delete;

  // What is on the dome from now on: a picture of that view.
  void Set(const Options& options, const Picture& picture);

  // Draws and shows it, where anything is new.
  void Refresh();

  // Turns the head by what happened, and returns the rest: keys.
  std::vector<WindowEvent> TakeEvents();

  bool IsClosing() const { return this->Window.IsClosing(); }

private:
  void Turn(const WindowEvent& event);

  // What the dome's shape follows from.
  using Shape = std::tuple<std::string, double, double, double, wfv::LensCoefficients, double,
    std::array<double, 6>, const wfv::DirectionMap*>;

  GlfwWindow Window;
  vtkNew<GlfwRenderWindow> Target; // goes first
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkImageData> Image;
  vtkNew<vtkPolyDataMapper> Mapper;
  std::optional<Shape> Of; // the mapper's dome
  double Yaw = 0;          // degrees, to the right
  double Pitch = 0;
  bool Turned = false; // by hand
  bool Dragging = false;
  bool IsNew = true;
  std::array<double, 2> At{ { 0, 0 } }; // the pointer
};
}

#endif
