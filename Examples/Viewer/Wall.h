// SPDX-License-Identifier: BSD-3-Clause
// The windows that show one picture: one, or a wall of them, each a part.
#ifndef WideFoVWall_h
#define WideFoVWall_h

#include "GlfwWindow.h"
#include "Scene.h"
#include "ViewerOptions.h"
#include "ViewerStage.h"

#include <memory>
#include <vector>

namespace widefov
{
// Speaks of the whole picture: its size and its pixels, wherever they are shown. All windows
// are drawn from the same options; events come from any of them.
class Wall
{
public:
  // The scene must outlive this. Throws a Failure with ExitFailed: no OpenGL, windows larger
  // than it draws, fewer monitors than windows where they are to fill them.
  Wall(const ViewerOptions& options, const Scene& scene, const std::string& title);

  bool IsSeveral() const { return this->Panes.size() > 1; }

  // As those of GlfwWindow; Wait at most so many seconds, below 0 as long as it takes.
  void Poll();
  void Wait(double seconds = -1);
  std::vector<WindowEvent> TakeEvents();
  bool TakeDamage();
  bool IsClosing() const;
  void Close();
  void CheckAlive() const;
  bool IsFullScreen() const;
  void SetFullScreen(bool on);
  void NextMonitor();
  std::array<double, 2> GetCursor() const;

  // Of the whole picture, pixels; 0 where a window shows nothing.
  std::array<int, 2> GetSize() const;

  // Can OpenGL draw windows as large as these are?
  bool IsWithinLimits() const;

  // Of all windows, as ViewerStage::SetUpdateRate.
  void SetUpdateRate(double rate);

  // Draws all windows and shows them. The text stands on the first; the cost is that of all.
  FrameCost Draw(const Options& options, const std::function<std::string(const FrameCost&)>& text,
    const std::string& help);

  // Shows the other eye, where a layout shows one after the other and the windows do not do it
  // themselves; false where there is nothing to flip.
  bool Flip();

  // True where such a layout is shown by windows with a back buffer for each eye.
  bool HasBuffersForBoth() const;

  // The whole picture without text, not shown.
  Picture Take(const Options& options);

private:
  struct Pane
  {
    std::unique_ptr<GlfwWindow> Window;
    std::unique_ptr<ViewerStage> Stage; // goes first
    Tile Where;
  };

  // Pixels of a window to those of the whole picture.
  std::array<double, 2> ToWhole(const Pane& pane, double x, double y) const;

  int Columns;
  int Rows;
  std::vector<Pane> Panes; // row by row, from the upper left
};
}

#endif
