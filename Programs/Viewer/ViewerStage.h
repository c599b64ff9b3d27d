// SPDX-License-Identifier: BSD-3-Clause
// The scene in the window: what draws it, and what a frame cost.
#ifndef WideFoVViewerStage_h
#define WideFoVViewerStage_h

#include "vtkWideFoVAbi.h"

#include "Crosshair.h"
#include "GlfwRenderWindow.h"
#include "Options/Options.h"
#include "Overlay.h"
#include "Pictures/Frame.h"
#include "Pictures/ImageOutput.h"
#include "Scenes/Scene.h"
#include "Scenes/ShownScene.h"
#include "Viewing/CoarseScene.h"

#include <vtkCommand.h>
#include <vtkNew.h>
#include <vtkScalarBarActor.h>
#include <vtkSmartPointer.h>
#include <vtkWideFoVPass.h>
#include <vtkWideFoVRenderer.h>

#include <chrono>
#include <functional>
#include <optional>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkPanoramicProjectionPass;
VTK_ABI_NAMESPACE_END

namespace widefov
{
// Draw calls of a frame, by what they were drawn with. Unknown where stock VTK drew.
struct DrawCounts
{
  int Plain = 0;
  int PreClip = 0;
  int Tessellate = 0;
  int Exact = 0;
  int Props = 0; // drawn, and left out
  int PropsCulled = 0;
  long long Triangles = 0; // of clusters, those left out, and those projected
  long long TrianglesCulled = 0;
  long long TrianglesProjected = 0;
  int Relaxation = 0; // of the pass, the largest
};

struct FrameCost
{
  double Milliseconds = 0; // of the scene, without the text
  std::optional<DrawCounts> Draws;
  bool Coarse = false; // fewer samples, or triangles, than of a frame that stands still
};

// Of both.
FrameCost operator+(const FrameCost& a, const FrameCost& b);

// Which part of a picture a window shows: columns from the left, rows from the top.
struct Tile
{
  int Columns = 1;
  int Rows = 1;
  int Column = 0;
  int Row = 0;
};

class ViewerStage
{
public:
  // The window's context becomes current and stays so. stereo: the window has a back buffer for
  // each eye.
  ViewerStage(GLFWwindow* window, bool stereo, const Options& options, const Tile& tile);
  ~ViewerStage();
  ViewerStage(const ViewerStage&) = delete;
  ViewerStage& operator=(const ViewerStage&) = delete;

  // What the next frames show, instead of what they showed before. The scene must outlive this.
  void SetScene(const Scene& scene, const Look& look);

  // Of its volumes: the look's VolumeOpacity.
  void SetVolumeOpacity(double factor);

  // Largest width and height that this OpenGL draws, pixels.
  std::array<int, 2> GetLimits() const { return this->Limits; }

  // Draws this window's part of what the options say, at that size (pixels). `text` makes of
  // the cost what is to stand on the picture; nothing where it is empty. `aim`: of the crosshair,
  // sought by this frame where the pointer is in this window; nullptr: there is none.
  FrameCost Draw(const Options& options, const std::array<int, 2>& size,
    const std::function<std::string(const FrameCost&)>& text, const std::string& help,
    Aim* aim = nullptr);

  // Frames a second that the next frames are to keep to, coarser where they must; 0: as many as
  // there are.
  void SetUpdateRate(double rate);

  // True where the last frame is to be shown by turns, with Flip: of a layout that shows the
  // eyes so, in a window that does not do it itself.
  bool IsFlipping() const { return this->InTurn && !this->Window->HasBuffersForBoth(); }

  // Puts the other eye's picture of the last frame into the window, not shown yet.
  void Flip();

  // Puts the last frame into the window once more, not shown yet; black before the first one.
  void ShowAgain();

  // What draws over the picture that is in the window and not shown yet.
  void DrawOver(const std::function<void()>& draw) { this->Window->DrawOver(draw); }

  // What the last frame shows.
  Picture GetFrame() { return ReadPicture(this->Window); }

  // The same part, without text, not shown.
  Picture Take(const Options& options, const std::array<int, 2>& size);

private:
  void ShowTile();
  void PlaceIn(const Options& options, const std::array<int, 2>& size);
  void GiveWay(double rate);
  void ShowCoarse(bool coarse);
  void DrawFirst();
  void Apply(const Options& options, const std::array<int, 2>& size);
  void ApplyCubeMap(const Options& options);
  FrameCost Measure();
  bool HasRoom();
  void SetText();
  void SetCrosshair();
  void AfterScene();

  const Tile Where;
  const Scene* What = nullptr;
  vtkNew<GlfwRenderWindow> Window;
  vtkNew<vtkWideFoVRenderer> Renderer;
  vtkNew<vtkWideFoVPass> WidePass;
  vtkSmartPointer<vtkPanoramicProjectionPass> CubeMapPass;
  ShownScene Shown;
  Look Style;
  Scene Coarse; // the same with fewer triangles, once it was needed
  ShownScene ShownCoarse;
  int Samples = 0;          // of a frame that stands still
  bool Moves = false;       // the next frames
  double StillCost = 0;     // milliseconds of the last one that stood still
  bool HasFewer = false;    // samples
  bool IsCoarseNow = false; // the scene
  bool IsNew = false;       // the coarse one: nothing of it was drawn
  vtkSmartPointer<vtkScalarBarActor> Bar;
  Crosshair Cross;
  Overlay Texts;
  std::array<int, 2> Limits{ { 0, 0 } };
  std::string CubeMapOf; // what the pass was made for

  std::chrono::steady_clock::time_point Start;
  FrameCost Cost;
  bool HasFrame = false;
  bool InTurn = false; // one eye after the other
  int EyeShown = 0;    // 0 left, 1 right
  std::function<std::string(const FrameCost&)> TextOf;
  Aim* Aiming = nullptr;
  bool Aimed = false; // in this frame
};
}

#endif
