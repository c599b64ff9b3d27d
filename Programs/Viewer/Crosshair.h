// SPDX-License-Identifier: BSD-3-Clause
// A crosshair in the scene, at the place that is under the pointer.
#ifndef WideFoVCrosshair_h
#define WideFoVCrosshair_h

#include "Scenes/Look.h"

#include <vtkActor.h>
#include <vtkCursor3D.h>
#include <vtkNew.h>
#include <vtkWideFoVRenderer.h>

#include <array>
#include <optional>

namespace widefov
{
// Where it is: one for all windows, in one of which the pointer is.
struct Aim
{
  std::optional<std::array<double, 2>> Pointer; // pixels of a window's picture, from its upper
                                                // left; nothing in the other windows
  std::optional<Vector3> At;                    // place in the scene, found by the last frame
  Vector3 Eye{ { 0, 0, 0 } };                   // that found it
  double Pixel = 0;                             // scene units that are a pixel there
};

// Three lines along the scene's axes. Being in the scene it has the parallax of what it points
// at, in every projection and for both eyes; a renderer of its own draws it in front of all.
class Crosshair
{
public:
  Crosshair();

  vtkWideFoVRenderer* GetRenderer() { return this->Renderer; }

  // Sets the aim by the depths that `scene` has drawn into its window just now, for the eye that
  // it was drawn for: whatever drew them. Where nothing is: as far away as the aim was before.
  static void Find(vtkWideFoVRenderer* scene, Aim& aim);

  // At that place, or hidden. The renderer's camera must be that of the scene.
  void Show(const Aim* aim);

private:
  vtkNew<vtkCursor3D> Lines;
  vtkNew<vtkActor> Border; // shows on what is as light as the lines
  vtkNew<vtkActor> Cross;
  vtkNew<vtkWideFoVRenderer> Renderer;
};
}

#endif
