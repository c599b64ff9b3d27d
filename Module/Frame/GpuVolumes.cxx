// SPDX-License-Identifier: BSD-3-Clause
#include "Frame/GpuVolumes.h"

#include "Compat/SmartMapper.h"
#include "Drawables/Kinds/DrawableKinds.h"
#include "Drawables/Volumes.h"

#include "vtkObjectFactory.h"
#include "vtkVolume.h"

#include <algorithm>

namespace
{
// The volume stays as it was: SetMapper would modify it in every frame.
class VolumeAccess : public vtkVolume
{
public:
  static auto& MapperOf(vtkVolume* volume) { return volume->*(&VolumeAccess::Mapper); }
};

// On the processor, but of an image.
bool IsReplaced(vtkAbstractVolumeMapper* mapper)
{
  return mapper && !wfv::volume::IsByGpu(mapper) && mapper->GetNumberOfInputConnections(0) > 0 &&
    (wfv::HasTrait(mapper, wfv::OfImage) || wfv::HasTrait(mapper, wfv::MayChoose));
}

// VTK's library of GPU ray casting says how, where the program has it; else there is none.
vtkSmartPointer<vtkAbstractVolumeMapper> MakeMapper()
{
  vtkObject* const made = vtkObjectFactory::CreateInstance("vtkGPUVolumeRayCastMapper");
  return vtkSmartPointer<vtkAbstractVolumeMapper>::Take(
    vtkAbstractVolumeMapper::SafeDownCast(made));
}
}

namespace wfv
{
vtkAbstractVolumeMapper* GpuVolumes::Find(vtkAbstractVolumeMapper* own)
{
  std::vector<Entry>& all = this->Entries;
  all.erase(std::remove_if(all.begin(), all.end(), [](const Entry& entry) { return !entry.Own; }),
    all.end());
  auto found =
    std::find_if(all.begin(), all.end(), [own](const Entry& entry) { return entry.Own == own; });
  if (found == all.end())
  {
    all.push_back({ own, MakeMapper() });
    found = all.end() - 1;
  }
  if (found->OnGpu && found->Copied < own->GetMTime())
  {
    found->Copied = own->GetMTime();
    found->OnGpu = CopyVolume(own, found->OnGpu) ? found->OnGpu : nullptr;
  }
  return found->OnGpu;
}

GpuVolumes::Frame::Frame(GpuVolumes& volumes, vtkProp** props, int count)
{
  for (int i = 0; i < count; i++)
  {
    auto* const volume = vtkVolume::SafeDownCast(props[i]);
    vtkAbstractVolumeMapper* const own = volume ? volume->GetMapper() : nullptr;
    vtkAbstractVolumeMapper* const onGpu = IsReplaced(own) ? volumes.Find(own) : nullptr;
    if (onGpu)
    {
      this->Changes.push_back({ volume, own });
      VolumeAccess::MapperOf(volume) = onGpu;
    }
  }
}

GpuVolumes::Frame::~Frame()
{
  for (const Change& change : this->Changes)
  {
    VolumeAccess::MapperOf(change.Volume) = change.Own;
  }
}

void GpuVolumes::ReleaseGraphicsResources(vtkWindow* window)
{
  for (const Entry& entry : this->Entries)
  {
    if (entry.OnGpu)
    {
      entry.OnGpu->ReleaseGraphicsResources(window);
    }
  }
}
}
