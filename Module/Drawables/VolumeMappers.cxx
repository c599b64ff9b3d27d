// SPDX-License-Identifier: BSD-3-Clause
#include "Drawables/VolumeMappers.h"

#include "Compat/SmartMapper.h"

#include "vtkAbstractVolumeMapper.h"
#include "vtkSetGet.h"
#include "vtkVolume.h"

#include <mutex>
#include <set>
#include <string>

namespace wfv
{
namespace volume
{
namespace
{
// Those that draw by GPU ray casting, unless told otherwise.
bool IsByGpu(vtkAbstractVolumeMapper* mapper)
{
  if (mapper->IsA("vtkSmartVolumeMapper"))
  {
    return wfv::MayDrawByGpu(mapper);
  }
  return mapper->IsA("vtkGPUVolumeRayCastMapper") || mapper->IsA("vtkMultiBlockVolumeMapper");
}

// True once for each name.
bool IsNews(const std::string& name)
{
  static std::mutex lock;
  static std::set<std::string> said;
  const std::lock_guard<std::mutex> guard(lock);
  return said.insert(name).second;
}
}

bool IsFlatVolume(vtkProp* prop)
{
  auto* const volume = vtkVolume::SafeDownCast(prop);
  vtkAbstractVolumeMapper* const mapper = volume ? volume->GetMapper() : nullptr;
  if (!mapper || IsByGpu(mapper))
  {
    return false;
  }
  const std::string name = mapper->GetClassName();
  if (IsNews(name))
  {
    vtkGenericWarningMacro(
      << "a volume is left out: its mapper, a " << name
      << ", makes the rays of a flat picture. Use vtkGPUVolumeRayCastMapper or "
         "vtkSmartVolumeMapper, of an image that the data are resampled to.");
  }
  return true;
}
}
}
