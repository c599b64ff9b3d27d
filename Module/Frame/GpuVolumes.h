// SPDX-License-Identifier: BSD-3-Clause
// Volumes of images whose mappers make the rays of a flat picture on the processor: while a wide
// frame is drawn each has a mapper that casts them on the GPU, with the same settings.
#ifndef WideFoVGpuVolumes_h
#define WideFoVGpuVolumes_h

#include "vtkAbstractVolumeMapper.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkProp;
class vtkVolume;
class vtkWindow;
VTK_ABI_NAMESPACE_END

namespace wfv
{
class GpuVolumes
{
public:
  // As long as it lives the volumes among these props have such mappers.
  class Frame
  {
  public:
    Frame(GpuVolumes& volumes, vtkProp** props, int count);
    ~Frame();
    Frame(const Frame&) = delete;
    void operator=(const Frame&) = delete;

  private:
    struct Change
    {
      vtkVolume* Volume;
      vtkAbstractVolumeMapper* Own;
    };
    std::vector<Change> Changes;
  };

  // Frees what the mappers have of a window.
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  // One a mapper of the processor, as long as that exists.
  struct Entry
  {
    vtkWeakPointer<vtkAbstractVolumeMapper> Own;
    vtkSmartPointer<vtkAbstractVolumeMapper> OnGpu;
    vtkMTimeType Copied = 0;
  };
  vtkAbstractVolumeMapper* Find(vtkAbstractVolumeMapper* own);

  std::vector<Entry> Entries;
};
}

#endif
