// SPDX-License-Identifier: BSD-3-Clause
#include "WidePicture.h"

#include "PanoramaXmp.h"

#include "vtkAlgorithm.h"
#include "vtkImageAppend.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPVSession.h"
#include "vtkProcessModule.h"
#include "vtkRenderWindow.h"
#include "vtkSMParaViewPipelineController.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMSaveScreenshotProxy.h"
#include "vtkSMSession.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMViewProxy.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

namespace wfvplugin
{
namespace
{
// The values of the property Eyes.
enum EyesShown
{
  AsTheView,
  LeftEye,
  RightEye,
  FileEach,
  SideBySide,
  TopBottom
};

// "No change" of the screenshot's StereoMode.
constexpr int NoChange = -1;

using Image = vtkSmartPointer<vtkImageData>;
using Size = std::array<int, 2>;

// One picture of so many pixels, or nullptr.
Image Capture(vtkSMViewProxy* view, int stereoMode, const Size& size)
{
  vtkSMSessionProxyManager* const manager = view->GetSessionProxyManager();
  auto made = vtkSmartPointer<vtkSMProxy>::Take(manager->NewProxy("misc", "SaveScreenshot"));
  auto* const shot = vtkSMSaveScreenshotProxy::SafeDownCast(made);
  if (!shot)
  {
    return nullptr;
  }
  vtkNew<vtkSMParaViewPipelineController> controller;
  controller->PreInitializeProxy(shot);
  vtkSMPropertyHelper(shot, "View").Set(view);
  vtkSMPropertyHelper(shot, "SaveAllViews").Set(0);
  vtkSMPropertyHelper(shot, "ImageResolution").Set(size.data(), 2);
  vtkSMPropertyHelper(shot, "StereoMode").Set(stereoMode);
  controller->PostInitializeProxy(shot);
  Image picture = shot->CaptureImage();
  int drawn[3] = { 0, 0, 0 };
  if (picture)
  {
    picture->GetDimensions(drawn);
    picture->SetExtent(0, drawn[0] - 1, 0, drawn[1] - 1, 0, 0); // wherever the view is
  }
  if (drawn[0] != size[0] || drawn[1] != size[1])
  {
    vtkErrorWithObjectMacro(view,
      "No picture of " << size[0] << " x " << size[1]
                       << " pixels: choose a size with small factors, or one that fits the window");
    return nullptr;
  }
  return picture;
}

// Both eyes in one picture of so many pixels, the left one on the left or above.
Image CaptureBoth(vtkSMViewProxy* view, bool below, Size size)
{
  const int axis = below ? 1 : 0;
  if (size[axis] % 2 != 0)
  {
    vtkErrorWithObjectMacro(view, "Two eyes need an even number of pixels, not " << size[axis]);
    return nullptr;
  }
  size[axis] /= 2;
  const Image left = Capture(view, VTK_STEREO_LEFT, size);
  const Image right = left ? Capture(view, VTK_STEREO_RIGHT, size) : nullptr;
  if (!right)
  {
    return nullptr;
  }
  vtkNew<vtkImageAppend> both;
  both->SetAppendAxis(axis);
  both->AddInputData(below ? right : left); // rows count from the bottom
  both->AddInputData(below ? left : right);
  both->Update();
  return both->GetOutput();
}

bool IsJoined(int eyes)
{
  return eyes == SideBySide || eyes == TopBottom;
}

// An angle of view as the view draws it.
double FieldOfView(vtkSMViewProxy* view, const char* name, double most)
{
  constexpr double Least = 1; // degrees
  return std::clamp(vtkSMPropertyHelper(view, name).GetAsDouble(), Least, most);
}

// What viewers of panoramas want to know of a file of that size; empty where they know no such
// picture: of two eyes in one they know the layouts that are joined here, and no pitch.
std::string XmpOf(vtkSMViewProxy* view, const Size& size, int eyes)
{
  wfvxmp::Panorama p;
  p.Width = eyes == SideBySide ? size[0] / 2 : size[0];
  p.Height = eyes == TopBottom ? size[1] / 2 : size[1];
  p.HorizontalFov = FieldOfView(view, "HorizontalFieldOfView", p.HorizontalFov);
  p.VerticalFov = FieldOfView(view, "VerticalFieldOfView", p.VerticalFov);
  p.Pitch = vtkSMPropertyHelper(view, "Tilt").GetAsDouble();
  const std::string projection = vtkSMPropertyHelper(view, "Projection").GetAsString();
  const bool asTheView = eyes == AsTheView && vtkSMPropertyHelper(view, "StereoRender").GetAsInt();
  constexpr double Zenith = 90; // degrees: a picture beyond it stands on its head
  const double steepest = IsJoined(eyes) ? 0 : Zenith;
  if (projection != "equirectangular" || asTheView || std::abs(p.Pitch) > steepest)
  {
    return "";
  }
  return IsJoined(eyes) ? wfvxmp::SphericalXmp(p, eyes == TopBottom ? "top-bottom" : "left-right")
                        : wfvxmp::PanoramaXmp(p);
}

bool WriteFile(vtkSMViewProxy* view, vtkSMProxy* settings, vtkImageData* picture,
  const std::string& path, const std::string& xmp, vtkTypeUInt32 location)
{
  vtkSMSessionProxyManager* const manager = view->GetSessionProxyManager();
  auto writer =
    vtkSmartPointer<vtkSMProxy>::Take(manager->NewProxy("misc", "WideFoVPictureWriter"));
  auto made = vtkSmartPointer<vtkSMProxy>::Take(manager->NewProxy("misc", "RemoteWriterHelper"));
  auto* const helper = vtkSMSourceProxy::SafeDownCast(made);
  if (!writer || !helper)
  {
    return false;
  }
  vtkSMPropertyHelper(writer, "FileName").Set(path.c_str());
  vtkSMPropertyHelper(writer, "Xmp").Set(xmp.c_str());
  vtkSMPropertyHelper(writer, "Quality").Set(vtkSMPropertyHelper(settings, "Quality").GetAsInt());
  writer->UpdateVTKObjects();
  // a process that is client and server has the one place
  const bool alone = view->GetSession()->GetProcessRoles() != vtkPVSession::CLIENT;
  vtkSMPropertyHelper(helper, "Writer").Set(writer);
  vtkSMPropertyHelper(helper, "OutputDestination")
    .Set(static_cast<int>(alone ? vtkTypeUInt32(vtkPVSession::CLIENT) : location));
  helper->UpdateVTKObjects();
  auto* const algorithm = vtkAlgorithm::SafeDownCast(helper->GetClientSideObject());
  algorithm->SetInputDataObject(picture);
  helper->UpdatePipeline();
  algorithm->SetInputDataObject(nullptr);
  return true;
}

// A folder for each eye beside: name/left/file.png.
std::string InFolder(const std::string& path, const char* folder)
{
  const std::filesystem::path whole(path);
  return (whole.parent_path() / folder / whole.filename()).string();
}

struct Task
{
  std::string Path;
  int StereoMode;
};

std::vector<Task> TasksOf(int eyes, const std::string& path)
{
  switch (eyes)
  {
    case LeftEye:
      return { { path, VTK_STEREO_LEFT } };
    case RightEye:
      return { { path, VTK_STEREO_RIGHT } };
    case FileEach:
      return { { InFolder(path, "left"), VTK_STEREO_LEFT },
        { InFolder(path, "right"), VTK_STEREO_RIGHT } };
    default:
      return { { path, NoChange } };
  }
}
}

bool IsWideView(vtkSMProxy* view)
{
  return view && view->IsA("vtkSMWideFoVViewProxy");
}

std::vector<std::string> WriteWidePictures(
  vtkSMViewProxy* view, vtkSMProxy* settings, const std::string& path, vtkTypeUInt32 location)
{
  Size size;
  vtkSMPropertyHelper(settings, "Size").Get(size.data(), 2);
  const int eyes = vtkSMPropertyHelper(settings, "Eyes").GetAsInt();
  const bool joined = IsJoined(eyes);
  const bool described = vtkSMPropertyHelper(settings, "Metadata").GetAsInt() != 0;
  const std::string xmp = described ? XmpOf(view, size, eyes) : "";
  std::vector<std::string> written;
  for (const Task& task : TasksOf(eyes, path))
  {
    const Image picture =
      joined ? CaptureBoth(view, eyes == TopBottom, size) : Capture(view, task.StereoMode, size);
    // other ranks that run the script as well have only helped to draw
    const bool first = vtkProcessModule::GetProcessModule()->GetPartitionId() == 0;
    if (!picture || (first && !WriteFile(view, settings, picture, task.Path, xmp, location)))
    {
      return {};
    }
    written.push_back(task.Path);
  }
  return written;
}
}
