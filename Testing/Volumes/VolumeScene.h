// SPDX-License-Identifier: BSD-3-Clause
// A volume that is drawn, and the same as the march in double has it.
#ifndef WideFoVVolumeScene_h
#define WideFoVVolumeScene_h

#include "Drawing.h"
#include "VolumeMarch.h"

#include <vtkColorTransferFunction.h>
#include <vtkGPUVolumeRayCastMapper.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPiecewiseFunction.h>
#include <vtkRenderWindow.h>
#include <vtkSmartPointer.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>
#include <vtkWideFoVCamera.h>
#include <vtkWideFoVPass.h>
#include <vtkWideFoVRenderer.h>

#include <string>
#include <vector>

namespace wfv
{
namespace test
{
// VTK's wavelet, from -10 to 10 on each axis.
vtkSmartPointer<vtkImageData> Wavelet();

// The scalars of the office of the shared data on a regular grid; none where there is no such file.
vtkSmartPointer<vtkImageData> Office();

// The values that an image has, for the march.
reference::Field FieldOf(vtkImageData* image);

// An opaque ball of one colour, which no light falls on.
struct OpaqueBall
{
  vec3 Center{ 0 };
  double Radius = 0; // 0: none
  vec3 Color{ 0.2, 0.9, 0.3 };
};

struct VolumeError
{
  double Mean = 0;     // of a level, 0 to 1, over the pixels of the map
  double Max = 0;      // of any
  double Share = 0;    // of pixels that are off by more than ten of 255 levels
  double Seen = 0;     // share of pixels in which the march sees something of the volume
  double Contrast = 0; // standard deviation of what it sees, of a level
};

class VolumeScene
{
public:
  explicit VolumeScene(vtkImageData* image);

  // Both the drawing's and the march's.
  void SetBlend(reference::Blend mode);
  void SetBall(const OpaqueBall& ball);
  void SetTranslucent(const OpaqueBall& ball, double opacity); // the march's alone
  void AddClip(const reference::Plane& plane);
  void Crop(const std::array<double, 6>& box);
  void Shade();
  void SetGradientOpacity();
  void SetIsovalues(const std::vector<double>& values);
  void SetCut(const reference::Plane& plane);

  // The values between which the functions rise, and the opacity that they rise to.
  void SetFunctions(double low, double high, double opacity);

  // Draws; picture: a PNG that is written, where it has a name.
  void Draw(const Shot& shot, const std::string& picture = "");

  // Draws a screen of which three corners are seen from an eye, world, and compares that.
  VolumeError CompareScreen(vtkCamera* camera, const vec3& eye, const std::array<vec3, 3>& corners);

  // Whether stock VTK draws the projection perspective (no: the pass does).
  bool Stock = false;

  // Of the last picture, against the march.
  VolumeError Compare();

  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkWideFoVRenderer> Renderer;
  vtkNew<vtkWideFoVCamera> Camera;
  vtkNew<vtkWideFoVPass> Pass;
  vtkNew<vtkVolume> Volume;
  vtkSmartPointer<vtkGPUVolumeRayCastMapper> Mapper;
  reference::VolumeMarch March;

private:
  vec3 Expected(const ViewRay& ray, bool& seen) const;
  vec3 ExpectedOfCurve(const View& view, const vec2& ndc, bool& seen) const;
  double MeetBallAlong(const reference::VolumeMarch::Curve& curve) const;
  void WritePicture(const std::string& name) const;

  Shot LastShot;
  vec3 ExpectedThroughGlass(const vec3& origin, const vec3& direction, bool& seen) const;
  OpaqueBall Ball;
  OpaqueBall Glass;
  double GlassOpacity = 0;
  vec3 Background{ 0.1, 0.1, 0.2 };
  std::array<double, 16> ToWorld;
  std::vector<vec3> Drawn; // rows from the bottom
};
}
}

#endif
