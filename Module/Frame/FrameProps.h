// SPDX-License-Identifier: BSD-3-Clause
// What a pass knows of the props of a frame: asked for once a frame, and what follows from it kept
// until the prop or the view changes.
#ifndef WideFoVFrameProps_h
#define WideFoVFrameProps_h

#include "Drawables/CameraFilters.h"
#include "Drawables/PropTraits.h"
#include "vtkWideFoVAbi.h"

#include "vtkType.h"

#include <cstdint>
#include <vector>

namespace wfv
{
class Stages;
}

VTK_ABI_NAMESPACE_BEGIN
class vtkAlgorithm;
class vtkDataObject;
class vtkMapper;
class vtkProp;
class vtkRenderer;
class vtkWideFoVCamera;
class vtkWideFoVStage;
VTK_ABI_NAMESPACE_END

namespace wfv
{
class FrameProps
{
public:
  // Asks all of them for their bounds, which brings their data up to date, unless the renderer's
  // culler has just done so. Filters of their data are told of the view.
  void Gather(vtkRenderer* renderer, vtkWideFoVCamera* camera, vtkProp** props, int count);

  // Bounds of all visible props of the renderer, as vtkRenderer::ComputeVisiblePropBounds says
  // them, where these are the props gathered; false where there are others.
  bool GetSceneBounds(vtkRenderer* renderer, double bounds[6]) const;

  // For this view, by its number, what is not seen and what the others are drawn with.
  void Choose(wfv::Stages& stages, std::uint64_t view);

  int GetCount() const { return static_cast<int>(this->Entries.size()); }
  bool IsCulled(int i) const { return this->Entries[i].Culled; }
  vtkProp* GetProp(int i) const { return this->Entries[i].Prop; }
  vtkWideFoVStage* GetStage(int i) const { return this->Entries[i].Stage; }

private:
  struct Entry
  {
    vtkProp* Prop = nullptr; // compared; used in its frame only
    const void* Data = nullptr;
    const vtkMapper* Mapper = nullptr; // compared
    vtkAlgorithm* Producer = nullptr;  // of its data, through this port, until the mapper changes
    int Port = 0;
    vtkMTimeType Times[4] = { 0, 0, 0, 0 };
    double Bounds[6] = { 1, -1, 1, -1, 1, -1 };
    bool HasBounds = false;
    bool Culled = false;
    PropTraits Traits;
    vtkWideFoVStage* Stage = nullptr;
    bool Watched = false;   // its filters
    std::uint64_t View = 0; // that Culled and Stage are of; 0: none
  };

  static void Look(vtkProp* prop, bool asked, Entry& entry);
  static vtkDataObject* FindData(vtkMapper* mapper, const Entry& before, Entry& now);

  // Looks for filters that ask a camera; true if what they make changes.
  bool WatchFilters();

  std::vector<Entry> Entries;
  CameraFilters Filters;
};
}

#endif
