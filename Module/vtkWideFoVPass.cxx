// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWideFoVPass.h"

#include "Camera/ActiveCamera.h"
#include "Compat/Reports.h"
#include "Compat/VersionCheck.h"
#include "Frame/PartActor.h"
#include "Frame/Technique.h"
#include "Overrides.h"
#include "vtkWideFoVCamera.h"
#include "vtkWideFoVPassInternals.h"
#include "vtkWideFoVRenderer.h"
#include "vtkWideFoVScreenCamera.h"

#include "vtkObjectFactory.h"
#include "vtkProp.h"
#include "vtkRenderState.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"

#include <algorithm>
#include <vector>

vtkStandardNewMacro(vtkWideFoVPass);

static_assert(static_cast<int>(vtkWideFoVPass::AUTO) == wfv::TechniqueAuto &&
    static_cast<int>(vtkWideFoVPass::EXACT) == wfv::TechniqueExact &&
    static_cast<int>(vtkWideFoVPass::TESSELLATE) == wfv::TechniqueTessellate &&
    static_cast<int>(vtkWideFoVPass::PRECLIP) == wfv::TechniquePreClip &&
    static_cast<int>(vtkWideFoVPass::VERTEX) == wfv::TechniqueVertex,
  "the numbers of the techniques");

namespace
{
// Seconds: a frame that may take longer is for standing still.
constexpr double LongestShare = 1;

// How many times larger a frame is shown than drawn, by how much it is relaxed.
constexpr int Enlargements[wfv::FrameRate::Levels] = { 1, 1, 2, 3, 4 };
}

vtkWideFoVPass::vtkWideFoVPass()
  : Internal(new Internals)
{
  wfv::RegisterOverrides();
}

vtkWideFoVPass::~vtkWideFoVPass() = default;

void vtkWideFoVPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Technique: " << this->Technique << "\n"
     << indent << "Tolerance: " << this->Tolerance << "\n"
     << indent << "LabelUp: " << this->LabelUp << "\n"
     << indent << "DebugView: " << this->DebugView << "\n"
     << indent << "ShaderFolder: " << this->ShaderFolder << "\n"
     << indent << "DelegatePass: " << this->Internal->Delegate.Get() << "\n"
     << indent << "KeepUpdateRate: " << this->KeepUpdateRate << "\n"
     << indent << "Relaxation: " << this->Relaxation << "\n"
     << indent << "RelaxationRange: " << this->RelaxationRange[0] << ", "
     << this->RelaxationRange[1] << "\n"
     << indent << "Culling: " << this->Culling << "\n"
     << indent << "Statistics: " << this->GetStatistics() << "\n";
}

void vtkWideFoVPass::SetDelegatePass(vtkRenderPass* pass)
{
  if (this->Internal->Delegate != pass)
  {
    this->Internal->Delegate = pass;
    this->Modified();
  }
}

vtkRenderPass* vtkWideFoVPass::GetDelegatePass()
{
  return this->Internal->Delegate;
}

void vtkWideFoVPass::SetRelaxationRange(int least, int most)
{
  const int low = std::clamp<int>(least, NOT_RELAXED, QUARTER_SIZE);
  const int high = std::clamp<int>(most, low, QUARTER_SIZE);
  if (this->RelaxationRange[0] != low || this->RelaxationRange[1] != high)
  {
    this->RelaxationRange[0] = low;
    this->RelaxationRange[1] = high;
    this->Modified();
  }
}

void vtkWideFoVPass::SetRelaxationRange(const int range[2])
{
  this->SetRelaxationRange(range[0], range[1]);
}

namespace
{
// The eyes that the window draws one after the other, each as a frame of the renderer.
int CountEyes(vtkRenderWindow* window)
{
  const int type = window->GetStereoType();
  return window->GetStereoRender() && type != VTK_STEREO_LEFT && type != VTK_STEREO_RIGHT ? 2 : 1;
}
}

wfv::FrameRate::Allowed vtkWideFoVPass::FindRelaxations(bool small, bool samples) const
{
  wfv::FrameRate::Allowed allowed{ { true, small && samples, small, small, small } };
  for (int i = 0; i < wfv::FrameRate::Levels; i++)
  {
    allowed[i] = allowed[i] && i >= this->RelaxationRange[0] && i <= this->RelaxationRange[1];
  }
  return allowed;
}

// That of the window's pixels: by it fewer triangles come too near a border to be projected. But a
// smaller one, under which none are, is no tolerance that was asked for.
double vtkWideFoVPass::FindTolerance() const
{
  const double drawn = this->Tolerance / std::max(1, this->Internal->Enlargement);
  return std::max(drawn, std::min(this->Tolerance, wfv::Stages::LeastTolerance));
}

void vtkWideFoVPass::FindRelaxation(const vtkRenderState* s)
{
  Internals& in = *this->Internal;
  vtkRenderer* const renderer = s->GetRenderer();
  vtkRenderWindow* const window = renderer->GetRenderWindow();
  auto* const camera = vtkWideFoVCamera::SafeDownCast(renderer->GetActiveCamera());
  const int eyes = CountEyes(window);
  if (eyes > 1 && camera->GetCurrentEye() == vtkWideFoVCamera::RIGHT_EYE)
  {
    return; // both alike
  }
  const double share = renderer->GetAllocatedRenderTime() / eyes;
  const bool interactive =
    this->KeepUpdateRate && !renderer->GetSelector() && eyes * share <= LongestShare;
  this->Relaxation = NOT_RELAXED;
  in.Enlargement = 0;
  if (!interactive)
  {
    in.Rate.Stand();
    return;
  }
  const bool small = in.Small.IsPossible(s);
  const bool samples = window->GetMultiSamples() > 1;
  this->Relaxation = in.Rate.Move(
    renderer->GetLastRenderTimeInSeconds(), share, this->FindRelaxations(small, samples));
  in.Enlargement = small && this->Relaxation > 0 ? Enlargements[this->Relaxation] : 0;
}

bool vtkWideFoVPass::IsExact()
{
  return IsExactTechnique(this->Technique, this->Tolerance);
}

void vtkWideFoVPass::SetTechnique(int technique)
{
  const int number = wfv::TechniqueOf(technique);
  if (this->Technique != number)
  {
    this->Technique = number;
    this->Modified();
  }
}

const char* vtkWideFoVPass::GetTechniqueAsString(int technique)
{
  if (technique == TESSELLATE)
  {
    return "tessellate";
  }
  const std::vector<wfv::TechniqueEntry>& all = wfv::Techniques();
  const auto found = std::find_if(
    all.begin(), all.end(), [technique](const auto& known) { return known.Number == technique; });
  return found != all.end() ? found->Name.c_str() : nullptr;
}

bool vtkWideFoVPass::IsExactTechnique(int technique, double tolerance)
{
  return wfv::Stages::IsExactTechnique(technique, tolerance);
}

// A pass over the picture draws by a copy of the camera; the view is that of the frame's own.
void vtkWideFoVPass::Render(const vtkRenderState* s)
{
  vtkRenderer* const renderer = s->GetRenderer();
  auto* const wide = vtkWideFoVRenderer::SafeDownCast(renderer);
  vtkCamera* const camera = wide ? wide->GetFrameCamera() : nullptr;
  this->Internal->OfCopy = camera && renderer->GetActiveCamera() != camera;
  if (this->Internal->OfCopy)
  {
    const wfv::ActiveCamera active(renderer, camera);
    this->RenderActive(s);
    return;
  }
  this->RenderActive(s);
}

void vtkWideFoVPass::RenderActive(const vtkRenderState* s)
{
  Internals& in = *this->Internal;
  vtkRenderer* renderer = s->GetRenderer();
  if (wfv::FindFrame(renderer))
  {
    this->DrawDelegate(
      s); // within a pass of another kind, by which a wide one draws: once is enough
    return;
  }
  auto* camera = vtkWideFoVCamera::SafeDownCast(renderer->GetActiveCamera());
  this->ResetCounts(s->GetPropArrayCount());
  if (vtkWideFoVScreenCamera::SafeDownCast(camera))
  {
    in.Headlights->Begin(s);
    this->DrawDelegate(s);
    in.Headlights->End(s);
    return;
  }
  if (!camera || !camera->IsWide())
  {
    this->DrawFlat(s, camera);
    return;
  }
  wfv::WarnOfVtk();
  this->RenderWide(s, camera);
  this->TakeCounts();
}

void vtkWideFoVPass::DrawFlat(const vtkRenderState* s, vtkWideFoVCamera* camera)
{
  Internals& in = *this->Internal;
  if (camera)
  {
    in.Props.Gather(s->GetRenderer(), camera, s->GetPropArray(), s->GetPropArrayCount());
  }
  std::vector<vtkProp*> volumes;
  const bool moved = camera && camera->GetBaselineRadius() > 0;
  for (int i = 0; moved && i < s->GetPropArrayCount(); i++)
  {
    if (vtkVolume::SafeDownCast(s->GetPropArray()[i]))
    {
      volumes.push_back(s->GetPropArray()[i]);
    }
  }
  if (volumes.empty())
  {
    this->DrawDelegate(s);
    return;
  }
  vtkRenderState those(s->GetRenderer());
  those.SetPropArrayAndCount(volumes.data(), static_cast<int>(volumes.size()));
  in.Headlights->Begin(&those);
  this->DrawDelegate(s);
  in.Headlights->End(&those);
}

void vtkWideFoVPass::BeginStages(vtkRenderer* renderer, vtkWideFoVCamera* camera)
{
  wfv::Stages& stages = this->Internal->Stages;
  stages.SetCulling(this->Culling != 0);
  stages.Folder.SetPath(this->ShaderFolder);
  stages.SetEnlargement(std::max(1, this->Internal->Enlargement));
  stages.Begin(renderer, camera, this->Technique, this->FindTolerance());
  stages.SetDebugView(this->DebugView != 0);
}

void vtkWideFoVPass::RenderWide(const vtkRenderState* s, vtkWideFoVCamera* camera)
{
  Internals& in = *this->Internal;
  vtkRenderer* renderer = s->GetRenderer();
  const int count = s->GetPropArrayCount();
  vtkProp** props = s->GetPropArray();
  const wfv::GpuVolumes::Frame volumes(in.GpuVolumes, props, count);
  this->FindRelaxation(s);
  if (in.Enlargement > 0)
  {
    in.Small.Shrink(renderer, in.Enlargement);
  }
  in.Props.Gather(renderer, camera, props, count);
  this->BeginFrame(s, camera);
  this->BeginStages(renderer, camera);
  in.Props.Choose(in.Stages, in.Stages.GetViewNumber());
  const int seen = this->Cull(props, renderer->GetSelector() != nullptr);
  this->Figures.DrawnProps = seen + static_cast<int>(in.Flat.size() + in.Labels.size());
  this->Figures.CulledProps = count - this->Figures.DrawnProps;
  wfv::RendererAccess::SetCount(renderer, props, seen);
  const vtkWideFoVRenderer::BackgroundDrawer backdrop(
    renderer, [&in, renderer]() { in.Backdrop.Draw(renderer, in.Stages.Sky); });
  this->DrawSeen(s, seen);
  this->DrawLabels(renderer);
  wfv::RendererAccess::SetCount(renderer, props, count);
  for (int i = 0; i < count; i++)
  {
    props[i] = in.Props.GetProp(i);
  }
  in.Stages.End();
  this->WriteShaders();
  camera->EndFrame();
  if (this->KeepUpdateRate)
  {
    renderer->GetRenderWindow()->WaitForCompletion(); // the renderer takes the time
  }
}

void vtkWideFoVPass::WriteShaders()
{
  const std::string wrong = this->Internal->Stages.Folder.Write();
  if (!wrong.empty())
  {
    vtkErrorMacro(<< wrong);
  }
}

void vtkWideFoVPass::ResetCounts(int props)
{
  const wfv::FrameStatistics before = this->Figures;
  this->Figures = {};
  this->Figures.DrawnProps = props;
  this->Figures.MadePrograms = before.MadePrograms;
  this->Figures.ShaderTime = before.ShaderTime;
  this->Figures.ClusterTime = before.ClusterTime;
}

void vtkWideFoVPass::TakeCounts()
{
  const wfv::Stages& stages = this->Internal->Stages;
  wfv::FrameStatistics now = stages.Counts;
  now.DrawnProps = this->Figures.DrawnProps;
  now.CulledProps = this->Figures.CulledProps;
  const int unrefined = stages.Projected->GetNumberOfUnrefinedDraws();
  now.ProjectedDraws = stages.Projected->GetNumberOfDraws() - unrefined;
  now.PreClipDraws = stages.PreClip->GetNumberOfDraws() + unrefined;
  now.ExactDraws = stages.Exact->GetNumberOfDraws() + stages.ExactInSingle->GetNumberOfDraws();
  now.MadePrograms = stages.Shaders.GetNumberOfPrograms();
  now.ShaderTime = stages.Shaders.GetSeconds();
  now.ClusterTime = stages.ClusterTime.count();
  this->Figures = now;
}

int vtkWideFoVPass::GetNumberOfPlainDraws()
{
  if (wfv::IsNews("GetNumberOfPlainDraws"))
  {
    vtkWarningMacro(
      "GetNumberOfPlainDraws is called GetNumberOfProjectedDraws; the old name goes with "
      "the next release");
  }
  return this->GetNumberOfProjectedDraws();
}

void vtkWideFoVPass::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Internal->Stages.ReleaseGraphicsResources(window);
  this->Internal->Small.ReleaseGraphicsResources(window);
  this->Internal->Backdrop.ReleaseGraphicsResources();
  this->Internal->GpuVolumes.ReleaseGraphicsResources(window);
  if (this->Internal->Delegate)
  {
    this->Internal->Delegate->ReleaseGraphicsResources(window);
  }
  this->Superclass::ReleaseGraphicsResources(window);
}
