// SPDX-License-Identifier: BSD-3-Clause
#include "Drawables/FlatHabits.h"

#include "Compat/ImageModule.h"
#include "Drawables/Facing.h"
#include "vtkWideFoVCamera.h"

#include "vtkActor.h"
#include "vtkFlagpoleLabel.h"
#include "vtkFollower.h"
#include "vtkGlyph3DMapper.h"
#include "vtkImageMapper3D.h"
#include "vtkImageSlice.h"
#include "vtkProp3DFollower.h"

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
  LookAt(flat, camera, aspect, place);
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
