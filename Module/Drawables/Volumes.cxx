// SPDX-License-Identifier: BSD-3-Clause
#include "Drawables/Volumes.h"

#include "Compat/Reports.h"
#include "Compat/SmartMapper.h"
#include "Drawables/Kinds/DrawableKinds.h"

#include "vtkAbstractVolumeMapper.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkRenderer.h"
#include "vtkSetGet.h"
#include "vtkShaderProgram.h"
#include "vtkShaderProperty.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <string>

namespace wfv
{
namespace volume
{
namespace
{
// Pixels added round a rectangle: what float32 makes of it.
constexpr double Pad = 1.5;

bool Overlap(const vec4& a, const vec4& b)
{
  return a.x < b.z && b.x < a.z && a.y < b.w && b.y < a.w;
}

vec4 Both(const vec4& a, const vec4& b)
{
  return vec4(std::min(a.x, b.x), std::min(a.y, b.y), std::max(a.z, b.z), std::max(a.w, b.w));
}

// In the picture; empty where it is outside.
vec4 Padded(const vec4& r, const vec2& pixels)
{
  const vec2 pad = 2 * Pad / pixels;
  return vec4(std::max(r.x - pad.x, -1.0), std::max(r.y - pad.y, -1.0), std::min(r.z + pad.x, 1.0),
    std::min(r.w + pad.y, 1.0));
}

// What is drawn twice would be twice as dense.
Pictures Apart(const Pictures& pictures, const vec2& pixels)
{
  Pictures apart;
  for (int i = 0; i < pictures.Count; i++)
  {
    vec4 r = Padded(pictures.Bounds[i], pixels);
    if (r.x >= r.z || r.y >= r.w)
    {
      continue;
    }
    for (int j = 0; j < apart.Count; j++)
    {
      if (Overlap(r, apart.Bounds[j]))
      {
        r = Both(r, apart.Bounds[j]);
        apart.Bounds[j] = apart.Bounds[--apart.Count];
        j = -1; // the larger one may meet another
      }
    }
    apart.Add(r);
  }
  return apart;
}

bool HasOwnCode(vtkVolume* volume)
{
  vtkShaderProperty* const code = volume->GetShaderProperty();
  return code->HasVertexShaderCode() || code->HasFragmentShaderCode() ||
    code->HasGeometryShaderCode() || code->GetNumberOfShaderReplacements() > 0;
}

// Lights at the eye, one bit each of those without a position.
int FindDirectional(vtkRenderer* renderer)
{
  int found = 0;
  int number = 0;
  vtkLightCollection* const lights = renderer->GetLights();
  vtkCollectionSimpleIterator it;
  lights->InitTraversal(it);
  while (vtkLight* light = lights->GetNextLight(it))
  {
    if (light->GetSwitch() && !light->GetPositional())
    {
      found |= light->LightTypeIsHeadlight() ? 1 << number : 0;
      number++;
    }
  }
  return found;
}

// Across one layer of points VTK's texture coordinates are not defined.
bool IsOneLayer(vtkAbstractVolumeMapper* mapper)
{
  auto* const image = vtkImageData::SafeDownCast(mapper->GetInputDataObject(0, 0));
  const int* const d = image ? image->GetDimensions() : nullptr;
  const bool layer = d && std::count(d, d + 3, 1) > 0;
  if (layer && wfv::IsNews("volume of one layer"))
  {
    vtkGenericWarningMacro(<< "a volume is left out: its image of " << d[0] << " x " << d[1]
                           << " x " << d[2]
                           << " points has no thickness. vtkImageSlice shows it as a picture.");
  }
  return layer;
}
}

bool IsByGpu(vtkAbstractVolumeMapper* mapper)
{
  return HasTrait(mapper, GpuRays) && (!HasTrait(mapper, MayChoose) || MayDrawByGpu(mapper));
}

bool IsFlatVolume(vtkProp* prop)
{
  auto* const volume = vtkVolume::SafeDownCast(prop);
  vtkAbstractVolumeMapper* const mapper = volume ? volume->GetMapper() : nullptr;
  if (!mapper || IsByGpu(mapper))
  {
    return mapper && IsOneLayer(mapper);
  }
  const std::string name = mapper->GetClassName();
  if (wfv::IsNews("volume " + name))
  {
    vtkGenericWarningMacro(
      << "a volume is left out: its mapper, a " << name
      << ", makes the rays of a flat picture. Use vtkGPUVolumeRayCastMapper or "
         "vtkSmartVolumeMapper, of an image that the data are resampled to.");
  }
  return true;
}

Traits Describe(vtkRenderer* renderer, vtkVolume* volume)
{
  Traits traits;
  traits.Known = !HasOwnCode(volume);
  traits.Shaded = volume->GetProperty()->GetShade() != 0;
  traits.Directional = FindDirectional(renderer);
  return traits;
}

void SetCover(vtkShaderProgram* program, const Pictures& pictures, const vec2& pixels)
{
  const Pictures apart = Apart(pictures, pixels);
  float cover[3][4];
  for (int i = 0; i < apart.Count; i++)
  {
    for (int j = 0; j < 4; j++)
    {
      cover[i][j] = static_cast<float>(apart.Bounds[i][j]);
    }
  }
  program->SetUniformi("wfvCovers", apart.Count);
  if (apart.Count > 0)
  {
    program->SetUniform4fv("wfvCover", apart.Count, cover);
  }
}
}
}
