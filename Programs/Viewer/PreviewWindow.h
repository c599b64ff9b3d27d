// SPDX-License-Identifier: BSD-3-Clause
// A window beside the viewer's: its pictures where an audience has them.
#ifndef WideFoVPreviewWindow_h
#define WideFoVPreviewWindow_h

#include "GlfwRenderWindow.h"
#include "GlfwWindow.h"
#include "Options/Options.h"
#include "Pictures/ImageOutput.h"

#include <vtkActor.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderer.h>

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

namespace widefov
{
// From where.
enum class Sight
{
  Seat,   // on a dome, behind its middle
  Middle, // of the dome: a plain perspective
  Room    // flat screens where they stand, from outside
};

// Draws with stock VTK. Dragging turns the head, or the room.
class PreviewWindow
{
public:
  // So many pixels to the right of another window's left side; of so many pictures.
  PreviewWindow(const GlfwWindow& other, int right, Sight sight, std::size_t pictures);
  ~PreviewWindow();
  PreviewWindow(const PreviewWindow&) = delete;
  PreviewWindow& operator=(const PreviewWindow&) = delete;

  Sight GetSight() const { return this->From; }

  // What picture number i shows from now on: that view.
  void Set(std::size_t i, const Options& options, const Picture& picture);

  // Draws and shows it, where anything is new.
  void Refresh();

  // Turns the head by what happened, and returns the rest: keys.
  std::vector<WindowEvent> TakeEvents();

  bool IsClosing() const { return this->Window.IsClosing(); }

private:
  void AddWall();
  void PlaceCamera();
  void Turn(const WindowEvent& event);

  // What a dome's shape follows from.
  using Shape = std::tuple<std::string, double, double, double, wfv::LensCoefficients, double,
    std::array<double, 6>, const wfv::DirectionMap*>;

  struct Surface
  {
    vtkNew<vtkImageData> Image;
    vtkNew<vtkPolyDataMapper> Mapper;
    std::optional<Shape> Of; // the mapper's
  };

  GlfwWindow Window;
  vtkNew<GlfwRenderWindow> Target; // goes first
  vtkNew<vtkRenderer> Renderer;
  std::vector<std::unique_ptr<Surface>> Surfaces;
  Sight From;
  double Yaw = 0; // degrees, to the right
  double Pitch = 0;
  bool Turned = false; // by hand
  bool Dragging = false;
  bool IsNew = true;
  std::array<double, 2> At{ { 0, 0 } }; // the pointer
};
}

#endif
