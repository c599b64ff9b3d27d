// SPDX-License-Identifier: BSD-3-Clause
#include "Panel.h"

#include <imgui.h>

#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>

#include <algorithm>
#include <string>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace widefov
{
namespace
{
constexpr float LetterSize = 13; // of ImGui's own font, points
constexpr float Opacity = 0.85F;
constexpr int ShadingLanguage = 150; // of OpenGL 3.2

// Letters and widgets as large as the monitor asks for.
void SetLook(GLFWwindow* window)
{
  float scale = 1;
  glfwGetWindowContentScale(window, &scale, nullptr);
  scale = std::max(1.F, scale);
  ImGui::StyleColorsDark();
  ImGui::GetStyle().ScaleAllSizes(scale);
  ImGui::GetStyle().Colors[ImGuiCol_WindowBg].w = Opacity;
  ImFontConfig font;
  font.SizePixels = LetterSize * scale;
  ImGui::GetIO().Fonts->AddFontDefault(&font);
}
}

Panel::Panel(GLFWwindow* window)
  : Window(window)
  , Context(ImGui::CreateContext())
{
  this->MakeCurrent();
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr; // nothing is kept in the folder that the program is started in
  io.ConfigFlags |= ImGuiConfigFlags_NoMouseCursorChange;
  SetLook(window);
  ImGui_ImplGlfw_InitForOpenGL(window, true);
  ImGui_ImplOpenGL3_Init(("#version " + std::to_string(ShadingLanguage)).c_str());
}

Panel::~Panel()
{
  this->MakeCurrent();
  ImGui_ImplOpenGL3_Shutdown();
  ImGui_ImplGlfw_Shutdown();
  ImGui::DestroyContext(this->Context);
}

void Panel::MakeCurrent() const
{
  if (glfwGetCurrentContext() != this->Window)
  {
    glfwMakeContextCurrent(this->Window);
  }
}

void Panel::Layout(const std::function<void()>& contents)
{
  this->MakeCurrent();
  ImGui_ImplOpenGL3_NewFrame();
  ImGui_ImplGlfw_NewFrame();
  ImGui::NewFrame();
  contents();
  ImGui::Render();
  this->LaidOut = true;
}

void Panel::Draw()
{
  if (this->LaidOut)
  {
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
  }
}

bool Panel::WantsPointer() const
{
  return ImGui::GetIO().WantCaptureMouse;
}

bool Panel::WantsKeys() const
{
  return ImGui::GetIO().WantTextInput;
}
}
