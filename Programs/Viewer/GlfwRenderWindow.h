// SPDX-License-Identifier: BSD-3-Clause
// VTK's window without a window system, drawing into a window of GLFW.
#ifndef WideFoVGlfwRenderWindow_h
#define WideFoVGlfwRenderWindow_h

#include <vtkGenericOpenGLRenderWindow.h>

#include <functional>

struct GLFWwindow;

namespace widefov
{
// Its answers come from GLFW instead of from observers.
class GlfwRenderWindow : public vtkGenericOpenGLRenderWindow
{
public:
  static GlfwRenderWindow* New();
  vtkTypeMacro(GlfwRenderWindow, vtkGenericOpenGLRenderWindow);

  // Not owned; must outlive this. Its context becomes current, and OpenGL is initialized.
  // stereo: it has a back buffer for each eye.
  void SetWindow(GLFWwindow* window, bool stereo);

  // True where the window has a back buffer for each eye.
  bool HasBuffersForBoth() const { return this->TwoBuffers; }

  // Puts what the last frame drew for an eye (0 left, 1 right, of the type crystal eyes; else 0)
  // into the window's one back buffer.
  void ShowEye(int eye);

  // Calls what draws over the picture in the window's back buffer by OpenGL itself; it must leave
  // OpenGL's state as it finds it.
  void DrawOver(const std::function<void()>& draw);

  void MakeCurrent() override;
  bool IsCurrent() override;
  int SupportsOpenGL() override { return 1; } // the window would not be there
  vtkTypeBool IsDirect() override { return 1; }

protected:
  GlfwRenderWindow() = default;
  ~GlfwRenderWindow() override = default;

private:
  GlfwRenderWindow(const GlfwRenderWindow&) = delete;
  void operator=(const GlfwRenderWindow&) = delete;

  GLFWwindow* Handle = nullptr;
  bool TwoBuffers = false;
};
}

#endif
