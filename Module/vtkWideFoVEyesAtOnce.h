// SPDX-License-Identifier: BSD-3-Clause
// Props that are drawn for both eyes in one traversal: when the left eye is drawn, into a layer
// each; what the right one sees of them waits there until its turn.
#ifndef vtkWideFoVEyesAtOnce_h
#define vtkWideFoVEyesAtOnce_h

#include "vtkWideFoVAbi.h"
#include "vtkWideFoVEyeLayers.h"

#include "vtkType.h"

#include <cstdint>
#include <utility>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkProp;
class vtkRenderer;
VTK_ABI_NAMESPACE_END

namespace wfv
{
// Whether a prop can be: opaque triangles, of a mapper that is known, with the stage's shaders
// alone. What the frame may change is not looked at.
bool MayShareEyes(vtkProp* prop);

class EyesAtOnce
{
public:
  enum Role
  {
    Alone, // this eye is drawn, whatever the other does
    First, // both are drawn now
    Second // was drawn with the other
  };

  // A renderer's frame, for one eye.
  struct Frame
  {
    vtkRenderer* Renderer;
    int Eye;            // -1, 0, 1: vtkWideFoVCamera::GetCurrentEye
    std::uint64_t View; // its number, alike for both eyes
    vtkMTimeType Time;  // of what else there is
    vtkProp** Props;    // that may be shared
    int Count;
  };

  // Which of them this is. allowed: nothing speaks against drawing both. The frame that is Second
  // directly follows its First.
  Role Begin(const Frame& frame, bool allowed);

  // Draws the shared props of a frame that is First, and shows the left eye; shows what is there of
  // the right one where it is Second.
  void Draw(const Frame& frame, Role role);

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  struct Drawn
  {
    const void* Renderer = nullptr; // none: nothing waits
    int Type = 0;                   // of the window's stereo
    std::uint64_t View = 0;
    vtkMTimeType Time = 0;
    std::vector<std::pair<const void*, vtkMTimeType>> Props;

    bool operator==(const Drawn& o) const;
  };

  // Into memory that is kept.
  static void Note(const Frame& frame, Drawn& drawn);

  EyeLayers Layers;
  Drawn Waiting;
  Drawn Wanted;
};
}

#endif
