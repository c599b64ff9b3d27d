// SPDX-License-Identifier: BSD-3-Clause
#include "Drawables/Sky.h"

#include "Compat/Gl.h"
#include "Compat/Reports.h"

#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLActor.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLSkybox.h"
#include "vtkOpenGLState.h"
#include "vtkOpenGLTexture.h"
#include "vtkShaderProgram.h"
#include "vtkSmartPointer.h"
#include "vtkTexture.h"
#include "vtkTextureObject.h"

namespace wfv
{
namespace sky
{
namespace
{
class SkyAccess : public vtkOpenGLSkybox
{
public:
  static vtkActor* GetDrawer(vtkOpenGLSkybox* sky) { return sky->*(&SkyAccess::OpenGLActor); }
};

// vtkSkybox::Projection, in the keys of what draws it.
vtkInformationIntegerKey* ProjectionKey()
{
  static vtkInformationIntegerKey* const key =
    vtkInformationIntegerKey::MakeKey("SKY_PROJECTION", "wfv");
  return key;
}

}

bool Is(vtkProp* prop)
{
  return vtkOpenGLSkybox::SafeDownCast(prop) != nullptr;
}

bool IsLeftOut(vtkProp* prop, bool selects)
{
  auto* const sky = vtkOpenGLSkybox::SafeDownCast(prop);
  const bool bare = sky && !sky->GetTexture();
  if (bare && IsNews("sky without a texture"))
  {
    vtkGenericWarningMacro(<< "a vtkSkybox without a texture is left out; set one");
  }
  return bare || (sky && selects);
}

vtkActor* PrepareDrawer(vtkProp* prop)
{
  auto* const sky = vtkOpenGLSkybox::SafeDownCast(prop);
  if (!sky)
  {
    return nullptr;
  }
  vtkActor* const drawer = SkyAccess::GetDrawer(sky);
  if (!drawer->GetPropertyKeys())
  {
    drawer->SetPropertyKeys(vtkSmartPointer<vtkInformation>::New());
  }
  vtkInformation* const keys = drawer->GetPropertyKeys();
  vtkInformationIntegerKey* const key = ProjectionKey();
  if (!keys->Has(key) || keys->Get(key) != sky->GetProjection())
  {
    keys->Set(key, sky->GetProjection());
  }
  return drawer;
}

Kind KindOf(vtkProp* drawer)
{
  vtkInformation* const keys = drawer->GetPropertyKeys();
  const int projection = keys ? keys->Get(ProjectionKey()) : vtkSkybox::Cube;
  return projection == vtkSkybox::Sphere    ? Kind::Sphere
    : projection == vtkSkybox::StereoSphere ? Kind::Halves
    : projection == vtkSkybox::Floor        ? Kind::Floor
                                            : Kind::Cube;
}

void SetWorld(vtkShaderProgram* program, const double worldToView[16])
{
  double toWorld[16];
  vtkMatrix4x4::Invert(worldToView, toWorld);
  float turn[9]; // column by column
  float from[3];
  for (int i = 0; i < 3; i++)
  {
    for (int j = 0; j < 3; j++)
    {
      turn[3 * j + i] = static_cast<float>(toWorld[4 * i + j]);
    }
    from[i] = static_cast<float>(toWorld[4 * i + 3]);
  }
  program->SetUniformMatrix3x3("wfvSkyToWorld", turn);
  program->SetUniform3f("wfvSkyFrom", from);
}

// Levels are named, which leaves anisotropic filters without a meaning; Mesa's llvmpipe (22.3) then
// shows texels of elsewhere where one level ends and another begins.
void SetTexture(vtkShaderProgram* program, vtkProp* drawer, vtkWindow* window)
{
  auto* const actor = vtkActor::SafeDownCast(drawer);
  vtkTexture* const texture = actor ? actor->GetTexture() : nullptr;
  program->SetUniformi("wfvSkyMeans", texture && texture->GetMipmap());
  auto* const gl = vtkOpenGLRenderWindow::SafeDownCast(window);
  if (texture && texture->GetCubeMap() && gl)
  {
    // VTK asks for it with light from an environment alone: without it no face knows its neighbours
    gl->GetState()->vtkglEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
  }
  auto* const loaded = vtkOpenGLTexture::SafeDownCast(texture);
  vtkTextureObject* const object = loaded ? loaded->GetTextureObject() : nullptr;
  const bool known = object && object->GetContext() == window; // one may be another window's
  if (known && object->GetMaximumAnisotropicFiltering() > 1)
  {
    object->SetMaximumAnisotropicFiltering(1);
    object->Activate(); // tells OpenGL
  }
}
}
}
