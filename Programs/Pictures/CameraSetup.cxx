// SPDX-License-Identifier: BSD-3-Clause
#include "CameraSetup.h"

#include "Options/StereoChoice.h"
#include "Passes.h"
#include "Scenes/MeshBuilder.h"
#include "Text/Messages.h"

#include <vtkCamera.h>
#include <vtkNew.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkWideFoVCamera.h>
#include <vtkWideFoVScreenCamera.h>

#include <cmath>

namespace widefov
{
namespace
{
// Sine of the smallest angle between up and the direction of view.
constexpr double SmallestSine = 1e-6;

bool Parallel(const Vector3& a, const Vector3& b)
{
  return Length(Cross(a, b)) < SmallestSine;
}

// The focal point lies a scene's size ahead: its distance has no effect on a wide view,
// but VTK measures other things by it.
double FocalDistance(const Scene& scene)
{
  double b[6];
  if (!SceneBounds(scene, b))
  {
    return 1;
  }
  const double diagonal = std::hypot(b[1] - b[0], b[3] - b[2], b[5] - b[4]);
  return diagonal > 0 ? diagonal : 1;
}

void Place(vtkCamera* camera, const Pose& pose, double distance)
{
  const Vector3 ahead = pose.Eye + distance * pose.Direction;
  camera->SetPosition(pose.Eye.data());
  camera->SetFocalPoint(ahead.data());
  camera->SetViewUp(pose.Up.data());
}

void SetStereo(vtkWideFoVCamera* camera, const wfv::StereoOptions& s)
{
  camera->SetStereoModel((s.Model ? *s.Model : wfv::NoStereo()).Name.c_str());
  camera->SetInterpupillaryDistance(s.InterpupillaryDistance);
  camera->SetPoleFade(s.PoleFade[0], s.PoleFade[1]);
  camera->SetCircleConvergence(s.CircleConvergence);
  camera->SetWarpedStereo(s.Iod, s.Distance, s.Offset);
  camera->SetWarpedViewer(s.Viewer[0], s.Viewer[1]);
  camera->SetSeparation(s.Separation);
  camera->SetConvergence(s.Convergence);
}

void SetMeasured(vtkWideFoVCamera* camera, const wfv::MeasuredPicture& m)
{
  if (m.IsSet())
  {
    camera->SetMeasuredPicture(&m.Size.x, &m.Axis.x, &m.Focal.x);
  }
  else
  {
    camera->ClearMeasuredPicture();
  }
}

void SetView(vtkWideFoVCamera* camera, const Options& o)
{
  const wfv::ViewOptions& v = o.View;
  camera->SetProjection(o.Projection.c_str());
  camera->SetDirectionMap(v.Map);
  camera->SetHorizontalFieldOfView(v.HorizontalFov);
  camera->SetVerticalFieldOfView(v.VerticalFov);
  camera->SetTilt(v.Tilt);
  camera->SetDepthMapping(static_cast<int>(v.Mapping));
  camera->SetExactPerspective(DrawsPerspective(o));
  if (v.Lens != wfv::ViewOptions().Lens)
  {
    camera->SetLensCoefficients(v.Lens.data());
  }
  else
  {
    camera->ClearLens();
  }
  SetMeasured(camera, v.Measured);
  SetStereo(camera, v.Stereo);
  if (o.HasClip)
  {
    camera->SetClipRadii(v.Radii[0], v.Radii[1]);
  }
}

// The one that the renderer has, so that what a camera has found out about its view
// lasts, or a new one.
template <class Camera>
vtkSmartPointer<Camera> CameraOf(vtkRenderer* renderer)
{
  vtkSmartPointer<Camera> camera;
  if (renderer->IsActiveCameraCreated())
  {
    camera = Camera::SafeDownCast(renderer->GetActiveCamera());
  }
  if (!camera)
  {
    camera = vtkSmartPointer<Camera>::New();
    renderer->SetActiveCamera(camera);
  }
  return camera;
}

// The room is placed; a head with a position stands in it.
void SetScreen(vtkWideFoVScreenCamera* camera, const Options& o)
{
  const wfv::Screen& s = o.Screen->Corners;
  camera->SetScreen(&s.LowerLeft.x, &s.LowerRight.x, &s.UpperRight.x);
  const wfv::Head head = o.Head && o.Head->HasPosition ? o.Head->Head : wfv::Head();
  camera->SetHeadPosition(head.Position.x, head.Position.y, head.Position.z);
  camera->SetHeadTurn(head.Turn[0], head.Turn[1], head.Turn[2], head.Turn[3]);
  camera->SetInterpupillaryDistance(o.View.Stereo.InterpupillaryDistance);
  if (o.HasClip)
  {
    camera->SetClipRadii(o.View.Radii[0], o.View.Radii[1]);
  }
}
}

// Up need not be at right angles to the direction.
Vector3 ToWorld(const Pose& pose, const wfv::vec3& v)
{
  const Vector3 right = Unit(Cross(pose.Direction, pose.Up));
  const Vector3 up = Cross(right, pose.Direction);
  return v.x * right + v.y * up + -v.z * pose.Direction;
}

namespace
{
// The display is on the head, or, where it is screens in a room, the room turns with it.
void MoveWithHead(Pose& pose, const HeadPose& head)
{
  const Pose room = pose;
  pose.Eye = room.Eye + ToWorld(room, head.Head.Position);
  pose.Direction = ToWorld(room, wfv::TurnedWith(head.Head, wfv::vec3(0, 0, -1)));
  pose.Up = ToWorld(room, wfv::TurnedWith(head.Head, wfv::vec3(0, 1, 0)));
}
}

Vector3 UsualDirection(const Vector3& up)
{
  const Vector3 ahead{ { 0, 0, -1 } };
  return Parallel(Unit(up), ahead) ? Vector3{ { 0, 1, 0 } } : ahead;
}

Pose MakePose(const Scene& scene, const Options& o)
{
  Pose pose;
  pose.Eye = o.Eye.value_or(SceneEye(scene));
  const Vector3 up = o.Up.value_or(Vector3{ { 0, 1, 0 } });
  Vector3 direction = o.Direction.value_or(UsualDirection(up));
  if (o.LookAt)
  {
    direction = *o.LookAt - pose.Eye;
    if (Length(direction) == 0)
    {
      FailUsage("--look-at is where the eye is (" + Text(pose.Eye[0]) + "," + Text(pose.Eye[1]) +
        "," + Text(pose.Eye[2]) + "); choose another point, or give --eye");
    }
  }
  pose.Direction = Unit(direction);
  pose.Up = Unit(up);
  if (Parallel(pose.Direction, pose.Up))
  {
    if (o.Up)
    {
      FailUsage("--up is parallel to the direction of view; choose another");
    }
    pose.Up = { { 0, 0, pose.Direction[1] > 0 ? 1. : -1. } }; // as if the head were tilted back
  }
  if (o.Head && !(o.Screen && o.Head->HasPosition))
  {
    MoveWithHead(pose, *o.Head);
  }
  return pose;
}

void SetCamera(vtkRenderer* renderer, const Scene& scene, const Options& o)
{
  const Pose pose = MakePose(scene, o);
  const double distance = FocalDistance(scene);
  if (o.Screen && !ShowsCube(o))
  {
    const auto camera = CameraOf<vtkWideFoVScreenCamera>(renderer);
    Place(camera, pose, distance);
    SetScreen(camera, o);
    return;
  }
  if (o.Technique != Technique::CubeMap)
  {
    const auto camera = CameraOf<vtkWideFoVCamera>(renderer);
    Place(camera, pose, distance);
    SetView(camera, o);
    return;
  }
  vtkNew<vtkCamera> camera;
  Place(camera, pose, distance);
  camera->OrthogonalizeViewUp();
  camera->Pitch(o.View.Tilt);
  camera->OrthogonalizeViewUp();
  renderer->SetActiveCamera(camera);
}
}
