// SPDX-License-Identifier: BSD-3-Clause
// Widgets over the picture of a window.
#ifndef WideFoVPanel_h
#define WideFoVPanel_h

#include <functional>
#include <memory>
#include <string>

struct GLFWwindow;

namespace widefov
{
// It takes the events of its window beside the window itself while it lives. One at a time.
class Panel
{
public:
  Panel() = default;
  virtual ~Panel() = default;
  Panel(const Panel&) = delete;
  Panel& operator=(const Panel&) = delete;

  // Lays out anew what `contents` makes by Dear ImGui's functions, after what happened since.
  virtual void Layout(const std::function<void()>& contents) = 0;

  // Lays out these lines alone, in the middle of the window.
  virtual void LayoutText(const std::string& text) = 0;

  // What was laid out, into the framebuffer that is bound.
  virtual void Draw() = 0;

  // The keyboard is the widgets', not the picture's.
  virtual bool WantsKeys() const = 0;
};

// False where the viewer was built without Dear ImGui.
bool HasPanels();

// Nothing where there are none, or OpenGL does not let them draw.
std::unique_ptr<Panel> MakePanel(GLFWwindow* window);
}

#endif
