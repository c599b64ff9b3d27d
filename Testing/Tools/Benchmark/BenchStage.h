// SPDX-License-Identifier: BSD-3-Clause
// Every run of one scene, side by side in one window for each size and number of samples, so that
// they can be drawn in turn.
#ifndef WideFoVBenchStage_h
#define WideFoVBenchStage_h

#include "BenchScenes.h"
#include "Record.h"

#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkWideFoVPass.h>

#include <map>
#include <vector>

namespace wfv
{
namespace bench
{
// One run, ready to be drawn: a renderer and actors of its own. Buffers of points are
// VTK's to share.
struct BenchEntry
{
  bench::Run Run;
  vtkRenderWindow* Window = nullptr;
  vtkSmartPointer<vtkRenderer> Renderer;
  vtkSmartPointer<vtkWideFoVPass> WidePass; // none for cubemaps and the floor
  std::vector<vtkSmartPointer<vtkActor>> Actors;
  widefov::Pose Start; // of the camera, before it moves
  int Moves = 0;       // of it, so far
};

class BenchStage
{
public:
  // Throws a Failure with ExitFailed where there is no display, or OpenGL too old.
  BenchStage(const BenchScene& scene, const std::vector<Run>& runs);
  ~BenchStage();
  BenchStage(const BenchStage&) = delete;
  BenchStage& operator=(const BenchStage&) = delete;

  std::vector<BenchEntry>& GetEntries() { return this->Entries; }
  const BenchScene& GetScene() const { return this->Scene; }

  // Moves the camera as the run says, then draws one frame, of both eyes where it has them, and
  // waits until it is drawn. Times are without the move. Throws a Failure with ExitFailed where VTK
  // reports an error.
  FrameTime Draw(BenchEntry& entry);

  // Draws one more frame; how often fragment programs run in it, by OpenGL's own count, which knows
  // no early depth test of blocks. None where OpenGL does not count.
  std::optional<long long> CountFragments(BenchEntry& entry);

  // Moves the floor's camera so near that as many pixels are covered as `pixels`, or as
  // near to it as it gets. Returns how many are.
  long FitFloor(BenchEntry& entry, long pixels);

private:
  void Move(BenchEntry& entry) const;
  vtkRenderWindow* WindowOf(const widefov::Options& options);
  void Add(const Run& run);

  const BenchScene& Scene;
  std::map<std::array<int, 3>, vtkSmartPointer<vtkRenderWindow>> Windows; // by size and samples
  std::vector<BenchEntry> Entries;
};
}
}

#endif
