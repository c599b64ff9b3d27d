// SPDX-License-Identifier: BSD-3-Clause
// Widgets over the picture of a window, by Dear ImGui.
#ifndef WideFoVPanel_h
#define WideFoVPanel_h

#include <functional>

struct GLFWwindow;
struct ImGuiContext;

namespace widefov
{
// It takes the events of its window beside the window itself while it lives. One at a time.
class Panel
{
public:
  explicit Panel(GLFWwindow* window);
  ~Panel();
  Panel(const Panel&) = delete;
  Panel& operator=(const Panel&) = delete;

  // Lays out anew what `contents` makes by ImGui's functions, after what happened since.
  void Layout(const std::function<void()>& contents);

  // What was laid out, into the framebuffer that is bound.
  void Draw();

  // The pointer or the keyboard is the widgets', not the picture's.
  bool WantsPointer() const;
  bool WantsKeys() const;

private:
  void MakeCurrent() const;

  GLFWwindow* Window;
  ImGuiContext* Context;
  bool LaidOut = false;
};
}

#endif
