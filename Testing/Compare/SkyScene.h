// SPDX-License-Identifier: BSD-3-Clause
// A window with a sky, and its pictures beside what each pixel's ray meets, in double.
#ifndef WideFoVTestSkyScene_h
#define WideFoVTestSkyScene_h

#include "Drawing.h"
#include "SkyTextures.h"
#include "vtkWideFoVCamera.h"
#include "vtkWideFoVPass.h"
#include "vtkWideFoVRenderer.h"

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkSkybox.h>

#include <functional>
#include <string>
#include <vector>

namespace wfv
{
namespace test
{
// Where there is nothing.
constexpr SkyColor NoSky(51, 0, 102);

struct SkyPicture
{
  int Width = 0;
  int Height = 0;
  std::vector<unsigned char> Colors; // rows from the bottom
  std::vector<float> Depths;         // 0 to 1

  // Calls it with each of the pixels.
  void ForEach(const std::function<void(int x, int y)>& look) const;

  SkyColor At(int x, int y) const;
  float DepthAt(int x, int y) const;
  vec2 NdcOf(int x, int y) const;
};

// All that a projection shows, a little downwards.
Shot WideSkyShot(const char* projection);

// A picture of SmoothColor. light: for an environment, with mipmaps, and in sRGB.
vtkSmartPointer<vtkTexture> SmoothSky(bool light = false);

// A ball whose colour is yellow, without light.
vtkSmartPointer<vtkActor> YellowBall(const vec3& place, double radius, double opacity);

struct SkyWindow
{
  SkyWindow();

  vtkWideFoVPass* Pass() { return vtkWideFoVPass::SafeDownCast(this->Renderer->GetPass()); }

  SkyPicture Draw(const Shot& shot);
  SkyPicture Read();

  // Of the picture drawn last.
  View GetView();

  // A ray in world coordinates.
  ViewRay InWorld(const ViewRay& ray);

  // Writes what was drawn last into the folder WIDEFOV_SKY_PICTURES, where there is one.
  void Keep(const std::string& name);

  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkWideFoVRenderer> Renderer;
  vtkNew<vtkWideFoVCamera> Camera;
  vtkNew<vtkSkybox> Sky;
};

// False where the map ends so near that float32 may see it elsewhere.
bool IsCertain(const View& view, const vec3& ndc);

// The colour that a ray in world coordinates meets far away.
using SkyLookup = std::function<SkyColor(const ViewRay& world)>;

struct SkyTally
{
  int Inside = 0;
  int Outside = 0;
  int Uncertain = 0; // beside the map's border: not looked at
  int Near = 0;      // pixels whose depth is not the far end
  double Worst = 0;  // levels that a pixel is off
  std::string Where;

  void Look(const SkyPicture& picture, int x, int y, const SkyColor& wanted);
};

// Each pixel against what is at infinity.
SkyTally CheckFar(SkyWindow& window, const SkyPicture& picture, const SkyLookup& lookup);
}
}

#endif
