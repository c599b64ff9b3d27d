// SPDX-License-Identifier: BSD-3-Clause
#include "Keys.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace widefov
{
namespace
{
struct Binding
{
  int Key;
  bool Shift;
  Action What;
};

constexpr Binding Bindings[] = {
  { GLFW_KEY_P, false, Action::NextProjection },
  { GLFW_KEY_P, true, Action::PreviousProjection },
  { GLFW_KEY_T, false, Action::NextTechnique },
  { GLFW_KEY_T, true, Action::PreviousTechnique },
  { GLFW_KEY_V, false, Action::ToggleDebugView },
  { GLFW_KEY_O, false, Action::NextStereo },
  { GLFW_KEY_O, true, Action::PreviousStereo },
  { GLFW_KEY_L, false, Action::NextLayout },
  { GLFW_KEY_L, true, Action::PreviousLayout },
  { GLFW_KEY_EQUAL, false, Action::ZoomIn },
  { GLFW_KEY_EQUAL, true, Action::ZoomIn },
  { GLFW_KEY_KP_ADD, false, Action::ZoomIn },
  { GLFW_KEY_MINUS, false, Action::ZoomOut },
  { GLFW_KEY_KP_SUBTRACT, false, Action::ZoomOut },
  { GLFW_KEY_LEFT, false, Action::TurnLeft },
  { GLFW_KEY_RIGHT, false, Action::TurnRight },
  { GLFW_KEY_UP, false, Action::TurnUp },
  { GLFW_KEY_DOWN, false, Action::TurnDown },
  { GLFW_KEY_HOME, false, Action::Reset },
  { GLFW_KEY_F2, false, Action::Screenshot },
  { GLFW_KEY_F3, false, Action::SaveSession },
  { GLFW_KEY_K, false, Action::AddPose },
  { GLFW_KEY_C, false, Action::PrintCommand },
  { GLFW_KEY_X, false, Action::ToggleCrosshair },
  { GLFW_KEY_B, false, Action::NextPreview },
  { GLFW_KEY_SPACE, false, Action::TogglePlay },
  { GLFW_KEY_PERIOD, false, Action::NextStep },
  { GLFW_KEY_COMMA, false, Action::PreviousStep },
  { GLFW_KEY_I, false, Action::ToggleText },
  { GLFW_KEY_N, false, Action::ToggleNumbers },
  { GLFW_KEY_F1, false, Action::ToggleHelp },
  { GLFW_KEY_TAB, false, Action::TogglePanel },
  { GLFW_KEY_F11, false, Action::ToggleFullScreen },
  { GLFW_KEY_M, false, Action::NextMonitor },
  { GLFW_KEY_ESCAPE, false, Action::Leave },
  { GLFW_KEY_Q, false, Action::Quit },
};

// What a person reads; the test of the documentation reads it, too.
struct HelpLine
{
  const char* Keys;
  const char* Text;
};

constexpr HelpLine Lines[] = {
  { "drag", "look around" },
  { "right drag", "orbit round the scene's centre" },
  { "wheel, + -", "field of view; size before screens" },
  { "W A S D", "fly ahead, left, back, right" },
  { "R F", "fly up, down (Shift: faster)" },
  { "arrows", "turn by 5 degrees" },
  { "Home", "back to the beginning" },
  { "P", "next projection (Shift: previous)" },
  { "T", "next technique (Shift: previous)" },
  { "V", "debug view" },
  { "O", "next stereo model (Shift: back)" },
  { "L", "next stereo layout (Shift: back)" },
  { "X", "3D crosshair on and off" },
  { "B", "preview: dome, perspective; room" },
  { "Space", "play and stop time, and head poses" },
  { ", .", "time step back, ahead" },
  { "F2", "screenshot, a file in this folder" },
  { "F3", "save all this in the session's file" },
  { "K", "add this pose to the list" },
  { "C", "print the command that draws this" },
  { "I", "text on and off" },
  { "N", "what a frame took, in numbers" },
  { "F11", "full screen" },
  { "M", "full screen on the next monitor" },
  { "F1", "this help" },
  { "Tab", "panel on and off" },
  { "Escape", "leave help, panel, full screen, all" },
  { "Q", "quit" },
};
constexpr std::size_t KeysWidth = 12; // letters
constexpr std::size_t TextWidth = 35;
}

std::optional<Action> ActionOf(int key, bool shift)
{
  for (const Binding& binding : Bindings)
  {
    if (binding.Key == key && binding.Shift == shift)
    {
      return binding.What;
    }
  }
  return std::nullopt;
}

std::optional<Motion> MotionOf(int key)
{
  switch (key)
  {
    case GLFW_KEY_W:
      return Motion{ 0, 0, 1 };
    case GLFW_KEY_S:
      return Motion{ 0, 0, -1 };
    case GLFW_KEY_A:
      return Motion{ -1, 0, 0 };
    case GLFW_KEY_D:
      return Motion{ 1, 0, 0 };
    case GLFW_KEY_R:
    case GLFW_KEY_E: // as it was while Q flew down
      return Motion{ 0, 1, 0 };
    case GLFW_KEY_F:
      return Motion{ 0, -1, 0 };
    default:
      return std::nullopt;
  }
}

bool Repeats(Action action)
{
  switch (action)
  {
    case Action::ZoomIn:
    case Action::ZoomOut:
    case Action::TurnLeft:
    case Action::TurnRight:
    case Action::TurnUp:
    case Action::TurnDown:
    case Action::NextStep:
    case Action::PreviousStep:
      return true;
    default:
      return false;
  }
}

std::string HelpText()
{
  std::string text;
  for (const HelpLine& line : Lines)
  {
    std::string keys = line.Keys;
    keys.resize(KeysWidth, ' ');
    std::string what = line.Text;
    what.resize(TextWidth, ' '); // one width, so that a centred block stays one
    text += (text.empty() ? "" : "\n") + keys + what;
  }
  return text;
}
}
