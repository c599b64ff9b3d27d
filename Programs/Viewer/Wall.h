// SPDX-License-Identifier: BSD-3-Clause
// The windows that are shown: one, a wall that shares one picture, or one for each screen of a
// room.
#ifndef WideFoVWall_h
#define WideFoVWall_h

#include "GlfwWindow.h"
#include "Panel.h"
#include "PreviewWindow.h"
#include "Scenes/Scene.h"
#include "ViewerOptions.h"
#include "ViewerStage.h"

#include <memory>
#include <optional>
#include <vector>

namespace widefov
{
// A place of what is shown: a picture, and pixels of it from its upper left. A wall has one
// picture, however many windows it has; of screens each has its own.
struct Place
{
  std::size_t Part = 0;
  std::array<double, 2> At{ { 0, 0 } };
};

// What is drawn over the scene.
struct Extras
{
  std::function<std::string(const FrameCost&)> Text; // of the cost; stands on the first window
  std::string Help;                                  // on the first window
  Aim* Cross = nullptr;                              // crosshair; its pointer is set here
  Place Pointer;
  Panel* Over = nullptr; // the picture of the first window
};

class Wall
{
public:
  // `parts`: the options of each picture; several are screens. Throws a Failure with ExitFailed:
  // no OpenGL, windows larger than it draws, fewer monitors than windows where they are to fill
  // them.
  Wall(const ViewerOptions& options, const std::vector<Options>& parts);

  // What the next frames show. The scene must outlive this.
  void SetScene(const Scene& scene, const Look& look);

  // Of its volumes: the look's VolumeOpacity.
  void SetVolumeOpacity(double factor);

  // What stands in the titles behind the program's name.
  void SetTitle(const std::string& title);

  bool IsSeveral() const { return this->Panes.size() > 1; }
  bool IsTiled() const { return this->Columns * this->Rows > 1; }

  // As those of GlfwWindow; Wait at most so many seconds, below 0 as long as it takes. Places of
  // the cursor are those of the event's part.
  void Poll();
  void Wait(double seconds = -1);
  std::vector<WindowEvent> TakeEvents();
  bool TakeDamage();
  bool IsClosing() const;
  void Close();
  void CheckAlive() const;
  bool IsFullScreen() const;
  void NextMonitor();
  void SetPointerShown(bool shown);
  Place GetCursor() const;

  // False, and nothing changes, where there are fewer monitors than windows.
  bool SetFullScreen(bool on);

  // Of a part's picture, pixels; 0 where nothing shows anything of it.
  std::array<int, 2> GetSize(std::size_t part) const;

  // Of all parts side by side.
  std::array<int, 2> GetSize() const;

  // Can OpenGL draw windows as large as these are?
  bool IsWithinLimits() const;

  // Of all windows, as ViewerStage::SetUpdateRate.
  void SetUpdateRate(double rate);

  // Draws all windows that show something, and shows them. The cost is that of all; what the
  // text has of windows that are drawn after the first one is that of the frame before.
  FrameCost Draw(const std::vector<Options>& parts, const Extras& extras);

  // Widgets for the first window, or nothing, as widefov::MakePanel. They must not outlive this.
  std::unique_ptr<Panel> MakePanel() const;

  // Shows the first window's last frame once more, with these widgets over it.
  void ShowAgain(Panel& over);

  // A window beside the others shows their pictures on a dome, then in a plain perspective, then it
  // goes; of screens the room, then it goes. False, and nothing changes, where several windows show
  // one picture.
  bool NextPreview();
  bool HasPreview() const { return this->Preview != nullptr; }

  // Draws the preview where it was turned.
  void RefreshPreview();

  // Shows the other eye, where a layout shows one after the other and the windows do not do it
  // themselves; false where there is nothing to flip.
  bool Flip(Panel* over);

  // True where such a layout is shown by windows with a back buffer for each eye.
  bool HasBuffersForBoth() const;

  // All parts side by side without text, not shown.
  Picture Take(const std::vector<Options>& parts);

private:
  struct Pane
  {
    std::unique_ptr<GlfwWindow> Window;
    std::unique_ptr<ViewerStage> Stage; // goes first
    Tile Where;
    std::size_t Part = 0;
    std::string Name;              // of a screen; empty: there are none
    std::optional<FrameCost> Cost; // of the last frame, where it showed anything
  };

  void AddPane(const ViewerOptions& options, const Options& part);
  FrameCost DrawPane(std::size_t i, const Options& part, const Extras& extras, const Place& under);
  void DrawOver(Panel* over) const;
  void DrawPreview(const std::vector<Options>& parts);
  FrameCost SumOfCosts() const;
  std::vector<std::size_t> OrderFrom(std::size_t first) const;

  // Pixels of a window to those of its part, and back: which window a place is in, as its part,
  // and where.
  std::array<double, 2> ToPart(const Pane& pane, double x, double y) const;
  std::optional<Place> FindPane(const Place& place) const;

  int Columns;
  int Rows;
  std::vector<Pane> Panes;                // a wall's row by row, from the upper left
  std::unique_ptr<PreviewWindow> Preview; // goes first
};
}

#endif
