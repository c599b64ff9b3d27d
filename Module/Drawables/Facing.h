// SPDX-License-Identifier: BSD-3-Clause
// How what turns to the viewer stands in a wide view.
#ifndef WideFoVFacing_h
#define WideFoVFacing_h

#include "vtkWideFoVAbi.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkCamera;
class vtkMatrix4x4;
class vtkRenderer;
class vtkWideFoVCamera;
VTK_ABI_NAMESPACE_END

namespace wfv
{
// Sets a camera to look at a place from where the wide view sees it, which differs from eye to eye,
// as upright as can be. aspect: of the picture.
void LookAt(vtkCamera* flat, vtkWideFoVCamera* camera, double aspect, const double place[3]);

// If a matrix is the one by which a vtkFollower faces the camera, it becomes the one by which the
// follower faces the eye upright, for the direction it is seen in. False of any other.
bool TurnFollower(vtkMatrix4x4* matrix, vtkWideFoVCamera* camera, double aspect);

// Direction in which the top of a label points.
enum class LabelUp
{
  Automatic, // Zenith if the map is round, else Picture
  Picture,   // the top of the picture
  World,     // the renderer's EnvironmentUp
  Zenith     // what is up for the camera: the centre of a dome's picture
};

// Returns the angle from the picture's top to where the top of a label at a place points, degrees,
// counterclockwise.
double FindLabelTurn(
  vtkRenderer* renderer, vtkWideFoVCamera* camera, LabelUp up, const double place[3]);
}

#endif
