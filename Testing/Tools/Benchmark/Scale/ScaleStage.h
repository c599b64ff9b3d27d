// SPDX-License-Identifier: BSD-3-Clause
// One way of drawing one scene, beside others in the same window.
#ifndef WideFoVScaleStage_h
#define WideFoVScaleStage_h

#include "ScaleScenes.h"

#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkWideFoVCamera.h>
#include <vtkWideFoVPass.h>

#include <string>
#include <vector>

namespace wfv
{
namespace scale
{
struct ScaleRun
{
  std::string Name;
  vtkSmartPointer<vtkRenderer> Renderer;
  vtkSmartPointer<vtkWideFoVPass> Pass; // none: stock VTK
  vtkSmartPointer<vtkWideFoVCamera> Camera;
  std::vector<double> Milliseconds;
};

// A window without several samples, so that little depends on its pixels. moves: it asks for 15
// frames a second, as VTK's interactors do while a camera turns.
vtkSmartPointer<vtkRenderWindow> MakeWindow(int width, int height, bool moves);

// Seen from the origin along -z, fields of view in degrees.
ScaleRun MakeWideRun(const std::string& name, const Actors& actors, const std::string& projection,
  double horizontal, double vertical);

// Stock VTK: a perspective from the origin along -z, or, where the angle is 0, a parallel camera
// outside that sees everything.
ScaleRun MakeStockRun(const std::string& name, const Actors& actors, double verticalAngle);

// Draws all of them in turn, `frames` times after two that do not count. `move` comes before
// each frame. Throws a Failure with ExitFailed where VTK reports an error.
using Move = std::function<void(const ScaleRun& run, int frame)>;
void DrawInTurn(vtkRenderWindow* window, std::vector<ScaleRun>& runs, int frames, const Move& move);
}
}

#endif
