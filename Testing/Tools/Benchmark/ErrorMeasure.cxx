// SPDX-License-Identifier: BSD-3-Clause
#include "ErrorMeasure.h"

#include "Pictures/CameraSetup.h"
#include "CellPictures.h"
#include "Text/Messages.h"
#include "System/Progress.h"

#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkWideFoVCamera.h>
#include <vtkWideFoVRenderer.h>

#include <algorithm>

namespace wfv
{
namespace bench
{
namespace
{
// b where a method has no tolerance of its own, pixels. What is exact shall be so.
constexpr double ExactTolerance = 0.02;

// More mismatched pixels than this are sampled: a search casts up to 450 rays a pixel.
constexpr std::size_t MostSearched = 20000;

double ToleranceOf(const Run& run)
{
  return run.Method == "exact" ? ExactTolerance : run.Options.Tolerance;
}

// The view and the pose of a run; the cubemap's are those of the same options drawn wide.
View ViewOf(const BenchStage& stage, const BenchEntry& entry, reference::Pose& pose)
{
  widefov::Options o = entry.Run.Options;
  o.Technique = widefov::Technique::Auto;
  vtkNew<vtkWideFoVRenderer> renderer;
  widefov::SetCamera(renderer, stage.GetScene().Scene, o);
  auto* const camera = vtkWideFoVCamera::SafeDownCast(renderer->GetActiveCamera());
  double bounds[6];
  widefov::SceneBounds(stage.GetScene().Scene, bounds);
  camera->ResetClipRadii(bounds);
  std::copy_n(camera->GetModelViewTransformMatrix()->GetData(), 16, pose.begin());
  return camera->GetView(o.View.Aspect);
}
}

ErrorMeasure::Truth& ErrorMeasure::TruthOf(BenchEntry& entry)
{
  const widefov::Options& o = entry.Run.Options;
  Truth& truth = this->Truths[o.Projection + " " + widefov::Text(o.View.HorizontalFov) + " " +
    widefov::Text(o.View.VerticalFov)];
  if (!truth.Caster)
  {
    const widefov::Progress progress("casting the rays of " + this->Stage.GetScene().Name);
    reference::Pose pose;
    const View view = ViewOf(this->Stage, entry, pose);
    truth.Caster.reset(new reference::RayCaster(SoupOf(this->Stage.GetScene(), pose), view));
    truth.Picture = truth.Caster->Render(o.Size[0], o.Size[1]);
  }
  return truth;
}

std::optional<ErrorFigures> ErrorMeasure::Measure(BenchEntry& entry)
{
  if (entry.Run.Method == "floor")
  {
    return std::nullopt;
  }
  const Truth& truth = this->TruthOf(entry);
  const widefov::Progress progress(
    "comparing " + NameOf(entry.Run) + " of " + this->Stage.GetScene().Name);
  reference::DrawnPicture drawn;
  if (entry.Run.Method == "cubemap")
  {
    drawn = DrawCubeMapCells(entry, this->Stage.GetScene());
  }
  else
  {
    entry.Renderer->DrawOn();
    drawn = DataPicture(entry).Draw(this->Stage.GetScene().FirstCells);
    entry.Renderer->DrawOff();
  }
  if (drawn.Width != truth.Picture.Width || drawn.Height != truth.Picture.Height)
  {
    widefov::Fail("drawing the cells of " + NameOf(entry.Run) + " failed");
  }
  ErrorFigures figures;
  figures.Tolerance = ToleranceOf(entry.Run);
  figures.HasDepth = entry.Run.Method != "cubemap";
  figures.Metrics =
    reference::Compare(drawn, *truth.Caster, truth.Picture, figures.Tolerance, MostSearched);
  return figures;
}

long ErrorMeasure::CountHits(BenchEntry& entry)
{
  const Truth& truth = this->TruthOf(entry);
  return std::count_if(truth.Picture.Hits.begin(), truth.Picture.Hits.end(),
    [](const reference::Hit& hit) { return hit.Cell >= 0; });
}
}
}
