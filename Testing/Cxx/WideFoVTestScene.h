// SPDX-License-Identifier: BSD-3-Clause
// Small scenes round the eye that the rendering tests share.
#ifndef WideFoVTestScene_h
#define WideFoVTestScene_h

#include "vtkWideFoVAbi.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkSmartPointer.h"
#include "vtkWideFoVCamera.h"
#include "vtkWideFoVPass.h"
#include "vtkWideFoVRenderer.h"

#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkActor;
class vtkAlgorithm;
class vtkPolyData;
VTK_ABI_NAMESPACE_END

// An offscreen window with a wide renderer and camera, the eye a little off centre.
struct WideFoVTestWindow
{
  WideFoVTestWindow(const char* projection, int width, int height);

  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkWideFoVRenderer> Renderer;
  vtkNew<vtkWideFoVCamera> Camera;

  vtkWideFoVPass* Pass() { return vtkWideFoVPass::SafeDownCast(this->Renderer->GetPass()); }
};

// The output of a filter as an actor in this colour.
vtkSmartPointer<vtkActor> MakeTestActor(vtkAlgorithm* source, double r, double g, double b);

// A room of twelve triangles round the eye, coloured by height.
vtkSmartPointer<vtkActor> MakeTestRoom();

// Eight cones on a ring round the eye; one crosses the seam.
void AddTestCones(vtkRenderer* renderer);

// Meridians and parallels every `step` degrees on a sphere of this radius, as
// polylines with a vertex every two degrees, or, coarse, every 45.
vtkSmartPointer<vtkPolyData> MakeGraticule(double radius, double step, bool coarse);

// Renders, compares with the baseline named on the command line; main's exit code.
int CompareWithBaseline(vtkRenderWindow* window, int argc, char* argv[]);

// Colour of a pixel, 0 to 255, rows from the bottom.
struct TestPixels
{
  explicit TestPixels(vtkRenderWindow* window);
  const unsigned char* At(int x, int y) const;
  std::vector<unsigned char> Copy() const; // of all, three numbers a pixel
  int Width;
  int Height;
  vtkSmartPointer<class vtkUnsignedCharArray> Data;
};

#endif
