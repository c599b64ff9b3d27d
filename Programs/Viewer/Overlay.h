// SPDX-License-Identifier: BSD-3-Clause
// Text on the picture: what is shown, and the keys.
#ifndef WideFoVOverlay_h
#define WideFoVOverlay_h

#include <vtkNew.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>

#include <string>

namespace widefov
{
// A renderer of its own, in front of the scene's: whatever draws that, the text stays.
class Overlay
{
public:
  Overlay();

  vtkRenderer* GetRenderer() { return this->Renderer; }

  // Text in the upper left corner of a picture of that size (pixels), small in a small one.
  // Empty: none.
  void SetText(const std::string& text, int width, int height);

  // Text in the middle of a picture of that size (pixels), made small where it must be.
  void SetHelp(const std::string& text, int width, int height);

private:
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkTextActor> Text;
  vtkNew<vtkTextActor> Help;
};
}

#endif
