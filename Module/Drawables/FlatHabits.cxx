// SPDX-License-Identifier: BSD-3-Clause
#include "Drawables/FlatHabits.h"

#include "Compat/ImageModule.h"
#include "Compat/Reports.h"
#include "Drawables/Kinds/DrawableKinds.h"
#include "vtkWideFoVCamera.h"

#include "vtkActor.h"
#include "vtkFlagpoleLabel.h"
#include "vtkFollower.h"
#include "vtkGlyph3DMapper.h"
#include "vtkImageMapper3D.h"
#include "vtkImageSlice.h"
#include "vtkMath.h"
#include "vtkProp3DFollower.h"

#include <cmath>
#include <string>

namespace
{
class GlyphAccess : public vtkGlyph3DMapper
{
public:
  static bool& Culls(vtkGlyph3DMapper* mapper) { return mapper->*(&GlyphAccess::CullingAndLOD); }
};

// Its setter would say that it was modified.
class FollowerAccess : public vtkFollower
{
public:
  static vtkCamera*& Of(vtkFollower* prop) { return prop->*(&FollowerAccess::Camera); }
};

class PropFollowerAccess : public vtkProp3DFollower
{
public:
  static vtkCamera*& Of(vtkProp3DFollower* prop) { return prop->*(&PropFollowerAccess::Camera); }
};

// The camera that a prop turns to; nullptr where it does not.
vtkCamera** FindFaced(vtkProp* prop)
{
  if (auto* const follower = vtkFollower::SafeDownCast(prop))
  {
    return &FollowerAccess::Of(follower);
  }
  auto* const follower = vtkProp3DFollower::SafeDownCast(prop);
  return follower ? &PropFollowerAccess::Of(follower) : nullptr;
}

// Where the ray to a place begins, which differs from eye to eye; the camera's own place where that
// is not seen.
void FindEye(vtkWideFoVCamera* camera, double aspect, const double place[3], double eye[3])
{
  double ndc[3];
  double direction[3];
  const bool seen = camera->WorldToNDC(place, aspect, ndc);
  if (!seen || !camera->NDCToRay(ndc, aspect, eye, direction))
  {
    camera->GetPosition(eye);
  }
}

// A camera that looks at a place from there, as upright as it can be.
void LookAt(vtkCamera* flat, vtkCamera* camera, const double eye[3], const double place[3])
{
  constexpr double Upright = 1e-3; // sine of the least angle between up and the line of sight
  double sight[3];
  double up[3];
  double side[3];
  vtkMath::Subtract(place, eye, sight);
  vtkMath::Normalize(sight);
  camera->GetViewUp(up);
  vtkMath::Normalize(up);
  vtkMath::Cross(sight, up, side);
  if (vtkMath::Norm(side) < Upright)
  {
    // straight above or below: its top is away from where the camera looks
    const double sign = vtkMath::Dot(sight, up) > 0 ? -1 : 1;
    camera->GetDirectionOfProjection(up);
    vtkMath::MultiplyScalar(up, sign);
  }
  flat->SetPosition(eye);
  flat->SetFocalPoint(place);
  flat->SetViewUp(up);
  flat->Modified(); // followers ask whether it was
}
}

namespace wfv
{
void FlatHabits::Face(vtkProp* prop, vtkWideFoVCamera* camera, double aspect)
{
  vtkCamera** const faced = FindFaced(prop);
  // a screenshot is drawn by a copy of the camera that the prop was told of
  vtkCamera* const before = faced ? vtkWideFoVCamera::SafeDownCast(*faced) : nullptr;
  if (!before)
  {
    return;
  }
  if (this->UsedCameras == this->Cameras.size())
  {
    this->Cameras.push_back(vtkSmartPointer<vtkCamera>::New());
  }
  vtkCamera* const flat = this->Cameras[this->UsedCameras++];
  double place[3];
  vtkProp3D::SafeDownCast(prop)->GetPosition(place);
  double eye[3];
  FindEye(camera, aspect, place, eye);
  LookAt(flat, camera, eye, place);
  // the prop's reference to its camera is kept for it; what is drawn may tell it of another
  // meanwhile
  flat->Register(nullptr);
  *faced = flat;
  this->Undo.emplace_back([faced, before, flat]() {
    vtkCamera* const gone = *faced == flat ? flat : before;
    *faced = *faced == flat ? before : *faced;
    gone->UnRegister(nullptr);
  });
}

// Nobody can ask such a prop for its followers.
void WarnOfFollowers(vtkProp* prop, vtkWideFoVCamera* camera)
{
  const double* const b = HasTrait(prop, KeepsFollowers) ? prop->GetBounds() : nullptr;
  if (!b || !vtkMath::AreBoundsInitialized(b))
  {
    return;
  }
  double eye[3];
  double ahead[3];
  camera->GetPosition(eye);
  camera->GetDirectionOfProjection(ahead);
  const double way[3] = { 0.5 * (b[0] + b[1]) - eye[0], 0.5 * (b[2] + b[3]) - eye[1],
    0.5 * (b[4] + b[5]) - eye[2] };
  if (vtkMath::Dot(way, ahead) < 0 && IsNews(std::string("followers of ") + prop->GetClassName()))
  {
    vtkWarningWithObjectMacro(prop, << "its text is upside down behind the eye");
  }
}

void FlatHabits::Stop(vtkProp* prop, vtkWideFoVCamera* camera, double aspect)
{
  this->Face(prop, camera, aspect);
  if (auto* const label = vtkFlagpoleLabel::SafeDownCast(prop))
  {
    // its flag may be as large as the angle of view makes it outside of frames
    label->Modified();
  }
  if (auto* const actor = vtkActor::SafeDownCast(prop))
  {
    auto* const glyphs = vtkGlyph3DMapper::SafeDownCast(actor->GetMapper());
    if (glyphs && GlyphAccess::Culls(glyphs))
    {
      GlyphAccess::Culls(glyphs) = false;
      this->Undo.emplace_back([glyphs]() { GlyphAccess::Culls(glyphs) = true; });
    }
    return;
  }
  WarnOfFollowers(prop, camera);
  auto* const slice = vtkImageSlice::SafeDownCast(prop);
  vtkImageMapper3D* const mapper = slice ? slice->GetMapper() : nullptr;
  if (mapper && SetResamplesToPixels(mapper, false))
  {
    this->Undo.emplace_back([mapper]() { SetResamplesToPixels(mapper, true); });
  }
}

void FlatHabits::Restore()
{
  for (const std::function<void()>& undo : this->Undo)
  {
    undo();
  }
  this->Undo.clear();
  this->UsedCameras = 0;
}
}
