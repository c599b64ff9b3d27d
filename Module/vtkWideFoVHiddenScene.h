// SPDX-License-Identifier: BSD-3-Clause
// Whether what was hidden in a frame still is.
#ifndef vtkWideFoVHiddenScene_h
#define vtkWideFoVHiddenScene_h

#include "vtkWideFoVAbi.h"
#include "vtkWideFoVDepthPicture.h"
#include "vtkWideFoVSampleRays.h"

#include <cstdint>
#include <utility>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkProp;
class vtkRenderer;
VTK_ABI_NAMESPACE_END

namespace wfv
{
// What stands before what, as long as nothing of it changes: a number for that, and the depths that
// were drawn meanwhile. Triangles that are farther than all that was seen where they are need not
// be drawn then.
class WFV_EXPORT HiddenScene
{
public:
  // A number that no other scene, of whichever renderer, has.
  static std::uint64_t MakeNumber();

  // What hides something, in the order in which it is drawn, and numbers that change with it. To be
  // filled before Begin.
  using Props = std::vector<std::pair<const void*, std::uint64_t>>;
  Props& GetProps() { return this->Coming; }

  // Before a frame. last: of what hides something, that whose drawing ends last, if anything is
  // to be hidden at all; view: its number; wait: frames for which a scene has to have stood.
  void Begin(const vtkProp* last, std::uint64_t view, int wait);

  // A mesh is drawn otherwise than in the last frame, if not seen otherwise.
  void Change() { this->Number = this->Number > 0 ? MakeNumber() : 0; }

  // 0: nothing is hidden.
  std::uint64_t GetNumber() const { return this->Number; }

  // In a frame that may show other things than the one before, and after which all is as it was: a
  // selection. Everything is drawn then.
  void SetPaused(bool paused) { this->Paused = paused; }
  bool IsPaused() const { return this->Paused; }

  // The depths that an eye (-1, 0, 1) saw of this scene, after all of it was drawn; nullptr where
  // they are not known, but asked for from then on.
  const DepthPicture* AskFor(int eye);

  // In which directions its pixels see; view: its own.
  const SampleRays& GetRays(const SortView& view);

  // When a prop has been drawn.
  void EndProp(const vtkProp* prop, vtkRenderer* renderer, int eye);

private:
  Props Coming;
  Props Last;
  const vtkProp* LastProp = nullptr;
  std::uint64_t View = 0;
  std::uint64_t Number = 0;
  int Frames = 0; // that it stood
  int Wait = 0;
  bool Paused = false;
  bool Asked = false;
  int Unasked = 0; // frames since somebody last asked
  struct
  {
    DepthPicture Depths;
    std::uint64_t Number = 0; // of the scene
  } Pictures[3];
  SampleRays Rays;
};
}

#endif
