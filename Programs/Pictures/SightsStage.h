// SPDX-License-Identifier: BSD-3-Clause
// Where several pictures of a scene are drawn, one after the other.
#ifndef WideFoVSightsStage_h
#define WideFoVSightsStage_h

#include "vtkWideFoVAbi.h"

#include "ImageOutput.h"
#include "Options/Options.h"
#include "Scenes/Scene.h"
#include "Scenes/ShownScene.h"
#include "System/Display.h"

#include <vtkNew.h>
#include <vtkProp.h>
#include <vtkRenderWindow.h>
#include <vtkSmartPointer.h>
#include <vtkWideFoVPass.h>
#include <vtkWideFoVRenderer.h>

#include <vector>

namespace widefov
{
// VTK's stereo types to draw with, one after the other; one for mono.
std::size_t CountEyes(const Options& options);

// What all pictures share: the window, the actors with their buffers. Throws a Failure as Render
// does.
class SightsStage
{
public:
  // The scene must last until there is another one, or no picture.
  SightsStage(const Scene& scene, const Options& options);

  // Shows another scene.
  void SetScene(const Scene& scene, const Options& options);

  // Draws one picture: of one eye, or both in one picture.
  void Draw(const Options& sight, std::size_t type);

  // The pictures of the sight's layout, of each eye its own.
  std::vector<Picture> Take(const Options& sight);

  void WaitForCompletion() { this->Window->WaitForCompletion(); }
  GlStrings GetStrings() { return QueryStrings(this->Window); }

private:
  const Scene* What = nullptr;
  GlLimits Limits;
  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkWideFoVRenderer> Renderer;
  vtkNew<vtkWideFoVPass> Pass;
  ShownScene Shown;
  vtkSmartPointer<vtkProp> Bar;
};
}

#endif
