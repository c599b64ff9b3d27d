// SPDX-License-Identifier: BSD-3-Clause
#include "Drawables/Billboards.h"

#include "Camera/ActiveCamera.h"
#include "Camera/Tile.h"
#include "vtkWideFoVCamera.h"

#include "vtkActor.h"
#include "vtkBillboardTextActor3D.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkOpenGLCamera.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkTexture.h"
#include "vtkTransform.h"

#include <algorithm>
#include <cmath>

namespace
{
// Where a text stands in the picture; false where that is not in it. The clip spheres are fitted to
// the data; a text may stand before or beyond them.
bool FindPlace(vtkWideFoVCamera* camera, double aspect, const double world[3], double ndc[3])
{
  if (camera->WorldToNDC(world, aspect, ndc))
  {
    return true;
  }
  constexpr double Within = 1e-6; // the clip spheres, relative
  double eye[3];
  camera->GetPosition(eye);
  const double distance = std::sqrt(vtkMath::Distance2BetweenPoints(world, eye));
  const double nearest = (1 + Within) * camera->GetNearClipRadius();
  const double farthest = (1 - Within) * camera->GetFarClipRadius();
  if (!(distance > 0))
  {
    return false;
  }
  const double share = std::min(std::max(distance, nearest), farthest) / distance;
  double place[3];
  for (int i = 0; i < 3; i++)
  {
    place[i] = eye[i] + share * (world[i] - eye[i]);
  }
  return camera->WorldToNDC(place, aspect, ndc);
}

// The rectangle that letters are drawn on, which is the prop's own.
class QuadAccess : public vtkBillboardTextActor3D
{
public:
  static vtkActor* Of(vtkBillboardTextActor3D* text) { return text->*(&QuadAccess::QuadActor); }
};

// A camera from the same place that shows `world` at `ndc`, and what is round it in parallel.
// aspect: of what is drawn to, in which a circle round there is one.
void ShowAt(
  vtkCamera* flat, vtkCamera* camera, const double world[3], const double ndc[3], double aspect)
{
  flat->SetPosition(camera->GetPosition());
  flat->SetFocalPoint(camera->GetFocalPoint());
  flat->SetViewUp(camera->GetViewUp());
  double place[4] = { world[0], world[1], world[2], 1 };
  flat->GetViewTransformMatrix()->MultiplyPoint(place, place);
  // the text's corners are floats in the scene's coordinates: it has to be large there
  const double scale = 1 / (vtkMath::Norm(world) + vtkMath::Norm(place));
  vtkNew<vtkMatrix4x4> projection;
  for (int i = 0; i < 3; i++)
  {
    const double along = i == 0 ? scale / aspect : scale;
    projection->SetElement(i, i, along);
    projection->SetElement(i, 3, ndc[i] - along * place[i]);
  }
  flat->SetExplicitProjectionTransformMatrix(projection);
  flat->UseExplicitProjectionTransformMatrixOn();
  flat->ParallelProjectionOn();
}

// Turns the text's rectangle about its place in the plane of a camera, by degrees counterclockwise,
// while this lives.
class Turned
{
public:
  Turned(vtkBillboardTextActor3D* text, vtkCamera* camera, double degrees)
    : Quad(degrees != 0 ? QuadAccess::Of(text) : nullptr)
  {
    if (!this->Quad)
    {
      return;
    }
    const double* const place = text->GetPosition();
    vtkNew<vtkTransform> turn;
    turn->Translate(place);
    turn->RotateWXYZ(degrees, camera->GetViewPlaneNormal());
    turn->Translate(-place[0], -place[1], -place[2]);
    this->Quad->SetUserMatrix(turn->GetMatrix());
    // pixels of the letters are no pixels of the picture
    if (vtkTexture* const letters = this->Quad->GetTexture())
    {
      letters->InterpolateOn();
    }
  }

  ~Turned()
  {
    if (this->Quad)
    {
      this->Quad->SetUserMatrix(nullptr);
    }
  }

  Turned(const Turned&) = delete;
  Turned& operator=(const Turned&) = delete;

private:
  vtkActor* Quad;
};
}

namespace wfv
{
bool Billboards::Take(vtkProp* prop)
{
  auto* const actor = vtkBillboardTextActor3D::SafeDownCast(prop);
  if (actor)
  {
    // what has no letters shows nothing, and ends the program where it is asked for its size
    if (actor->GetInput() && *actor->GetInput())
    {
      this->Actors.push_back(actor);
    }
  }
  return actor != nullptr;
}

void ShowBillboard(vtkBillboardTextActor3D* actor, vtkRenderer* renderer, vtkWideFoVCamera* camera,
  const float tile[4], LabelUp up, const std::function<void()>& draw)
{
  double ndc[3];
  if (!FindPlace(camera, PictureAspect(renderer), actor->GetPosition(), ndc))
  {
    return;
  }
  ndc[0] = tile[0] * ndc[0] + tile[2];
  ndc[1] = tile[1] * ndc[1] + tile[3];
  const double turn = FindLabelTurn(renderer, camera, up, actor->GetPosition());
  const int* const size = renderer->GetSize();
  vtkNew<vtkOpenGLCamera> flat;
  ShowAt(flat, camera, actor->GetPosition(), ndc, 1.0 * size[0] / std::max(size[1], 1));
  const ActiveCamera active(renderer, flat);
  // it faces where the camera looks, not the eye: lights of the scene would make it black elsewhere
  vtkProperty* const look = QuadAccess::Of(actor)->GetProperty();
  const bool lit = look->GetLighting();
  look->SetLighting(false);
  const Turned turned(actor, flat, turn);
  draw();
  look->SetLighting(lit);
}

void Billboards::Draw(
  vtkRenderer* renderer, vtkWideFoVCamera* camera, const float tile[4], LabelUp up) const
{
  for (vtkBillboardTextActor3D* const actor : this->Actors)
  {
    ShowBillboard(actor, renderer, camera, tile, up, [&] {
      actor->RenderOpaqueGeometry(renderer);
      if (actor->HasTranslucentPolygonalGeometry())
      {
        actor->RenderTranslucentPolygonalGeometry(renderer);
      }
    });
  }
}
}
