// SPDX-License-Identifier: BSD-3-Clause
// A window with a wide view whose props the tests of culling fill in, seen from random places with
// and without what is left out.
#ifndef WideFoVTestCullCrowd_h
#define WideFoVTestCullCrowd_h

#include "vtkWideFoVAbi.h"

#include "Projections/Projection.h"
#include "Stereo/Stereo.h"

#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWideFoVCamera.h>
#include <vtkWideFoVPass.h>
#include <vtkWideFoVRenderer.h>

#include <random>
#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkActor;
VTK_ABI_NAMESPACE_END

namespace wfv
{
namespace test
{
// What was left out of pictures.
struct LeftOut
{
  int Props = 0;
  int Clusters = 0;

  LeftOut& operator+=(const LeftOut& other);
};

class CullCrowd
{
public:
  // seed: of the places and sights. Pixels; samples a pixel, 0: one.
  CullCrowd(unsigned int seed, int width, int height, int samples);

  // From -1 to 1, and a place of such coordinates.
  double Unit();
  vec3 Place();

  // Puts the camera at a random place among the props, in this projection.
  void Point(const Projection& p);

  // Both eyes in one picture.
  void SetStereo(const std::string& model);
  void SetStereoRender(bool both) { this->Window->SetStereoRender(both); }

  vtkSmartPointer<vtkUnsignedCharArray> Draw(bool culling);

  // Draws so many random sights with and without culling: the pictures must be the same to the bit.
  // Of a planar projection none, for its culling is VTK's.
  LeftOut Compare(const Projection& p, int technique, int shots);

  vtkNew<vtkWideFoVPass> Pass;
  std::string Text; // the sight, for messages

  vtkNew<vtkWideFoVRenderer> Renderer;

protected:
  void Add(vtkActor* actor);

private:
  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkWideFoVCamera> Camera;
  StereoOptions Stereo;
  std::mt19937_64 Engine;
  std::uniform_real_distribution<double> Distribution{ -1, 1 };
  int Props = 0;
};
}
}

#endif
