// SPDX-License-Identifier: BSD-3-Clause
// By Dear ImGui.
#include "Panel.h"

#include <imgui.h>

#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>

#include <algorithm>

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

class ImGuiPanel : public Panel
{
public:
  explicit ImGuiPanel(GLFWwindow* window);
  ~ImGuiPanel() override;

  bool CanDraw() const { return this->HasOpenGL; }
  void Layout(const std::function<void()>& contents) override;
  void LayoutText(const std::string& text) override;
  void Draw() override;
  bool WantsKeys() const override { return ImGui::GetIO().WantTextInput; }

private:
  void MakeCurrent() const;

  GLFWwindow* Window;
  ImGuiContext* Context;
  bool HasOpenGL = false;
  bool LaidOut = false;
};

ImGuiPanel::ImGuiPanel(GLFWwindow* window)
  : Window(window)
  , Context(ImGui::CreateContext())
{
  this->MakeCurrent();
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr; // nothing is kept in the folder that the program is started in
  io.ConfigFlags |= ImGuiConfigFlags_NoMouseCursorChange;
  SetLook(window);
  ImGui_ImplGlfw_InitForOpenGL(window, true);
  this->HasOpenGL = ImGui_ImplOpenGL3_Init(("#version " + std::to_string(ShadingLanguage)).c_str());
}

ImGuiPanel::~ImGuiPanel()
{
  this->MakeCurrent();
  if (this->HasOpenGL)
  {
    ImGui_ImplOpenGL3_Shutdown();
  }
  ImGui_ImplGlfw_Shutdown();
  ImGui::DestroyContext(this->Context);
}

void ImGuiPanel::MakeCurrent() const
{
  if (glfwGetCurrentContext() != this->Window)
  {
    glfwMakeContextCurrent(this->Window);
  }
}

void ImGuiPanel::Layout(const std::function<void()>& contents)
{
  this->MakeCurrent();
  ImGui_ImplOpenGL3_NewFrame();
  ImGui_ImplGlfw_NewFrame();
  ImGui::NewFrame();
  contents();
  ImGui::Render();
  this->LaidOut = true;
}

void ImGuiPanel::LayoutText(const std::string& text)
{
  this->Layout([&text] {
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({ size.x / 2, size.y / 2 }, ImGuiCond_Always, { 0.5F, 0.5F });
    ImGui::Begin("text", nullptr,
      ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
        ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoSavedSettings);
    ImGui::TextUnformatted(text.c_str());
    ImGui::End();
  });
}

void ImGuiPanel::Draw()
{
  if (this->LaidOut)
  {
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
  }
}
}

bool HasPanels()
{
  return true;
}

std::unique_ptr<Panel> MakePanel(GLFWwindow* window)
{
  auto panel = std::make_unique<ImGuiPanel>(window);
  return panel->CanDraw() ? std::move(panel) : nullptr;
}
}
