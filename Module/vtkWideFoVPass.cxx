// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWideFoVPass.h"

#include "Compat/VersionCheck.h"
#include "Frame/BlockClusters.h"
#include "Frame/Technique.h"
#include "vtkWideFoVCamera.h"
#include "vtkWideFoVPassInternals.h"
#include "vtkWideFoVScreenCamera.h"

#include "vtkActor.h"
#include "vtkObjectFactory.h"
#include "vtkProp.h"
#include "vtkRenderState.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <algorithm>

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

// Fraction of its share under which a frame leaves time for a better one.
constexpr double SpareTime = 0.2;

// Pixels, by how much a frame is relaxed.
constexpr int MostRelaxed = 2;
constexpr double RelaxedTolerances[MostRelaxed + 1] = { 0, 1, 4 };
}

vtkWideFoVPass::vtkWideFoVPass()
  : Internal(new Internals)
{
}

vtkWideFoVPass::~vtkWideFoVPass() = default;

void vtkWideFoVPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Technique: " << this->Technique << "\n"
     << indent << "Tolerance: " << this->Tolerance << "\n"
     << indent << "DebugView: " << this->DebugView << "\n"
     << indent << "DelegatePass: " << this->Internal->Delegate.Get() << "\n"
     << indent << "NumberOfPlainDraws: " << this->NumberOfPlainDraws << "\n"
     << indent << "NumberOfPreClipDraws: " << this->NumberOfPreClipDraws << "\n"
     << indent << "NumberOfExactDraws: " << this->NumberOfExactDraws << "\n"
     << indent << "NumberOfTessellateDraws: " << this->NumberOfTessellateDraws << "\n"
     << indent << "KeepUpdateRate: " << this->KeepUpdateRate << "\n"
     << indent << "Relaxation: " << this->Relaxation << "\n"
     << indent << "Culling: " << this->Culling << "\n"
     << indent << "NumberOfDrawnProps: " << this->NumberOfDrawnProps << "\n"
     << indent << "NumberOfCulledProps: " << this->NumberOfCulledProps << "\n"
     << indent << "NumberOfClusters: " << this->NumberOfClusters << "\n"
     << indent << "NumberOfCulledClusters: " << this->NumberOfCulledClusters << "\n"
     << indent << "NumberOfTriangles: " << this->NumberOfTriangles << "\n"
     << indent << "NumberOfCulledTriangles: " << this->NumberOfCulledTriangles << "\n"
     << indent << "NumberOfProjectedTriangles: " << this->NumberOfProjectedTriangles << "\n"
     << indent << "NumberOfChosenProps: " << this->NumberOfChosenProps << "\n"
     << indent << "NumberOfClassifiedMeshes: " << this->NumberOfClassifiedMeshes << "\n"
     << indent << "NumberOfMadePrograms: " << this->NumberOfMadePrograms << "\n"
     << indent << "ShaderTime: " << this->ShaderTime << "\n"
     << indent << "ClusterTime: " << this->ClusterTime << "\n";
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

void vtkWideFoVPass::DrawDelegate(const vtkRenderState* s)
{
  if (this->Internal->Delegate)
  {
    this->Internal->Delegate->Render(s);
    this->NumberOfRenderedProps = this->Internal->Delegate->GetNumberOfRenderedProps();
    return;
  }
  vtkRenderer* renderer = s->GetRenderer();
  this->UpdateCamera(renderer);
  this->UpdateLightGeometry(renderer);
  this->UpdateLights(renderer);
  this->UpdateGeometry(renderer, s->GetFrameBuffer());
}

int vtkWideFoVPass::Cull(vtkProp** props)
{
  Internals& in = *this->Internal;
  int seen = 0;
  in.Chosen.clear();
  in.Texts.Clear();
  for (int i = 0; i < in.Props.GetCount(); i++)
  {
    if (!in.Texts.Take(in.Props.GetProp(i)) && !in.Props.IsUnseen(i))
    {
      in.Chosen.push_back(in.Props.GetStage(i));
      props[seen++] = in.Props.GetProp(i);
    }
  }
  return seen;
}

void vtkWideFoVPass::DrawProps(const vtkRenderState* s, vtkProp** props, int count)
{
  Internals& in = *this->Internal;
  in.Keys.resize(std::max<std::size_t>(in.Keys.size(), count));
  for (int i = 0; i < count; i++)
  {
    in.Keys[i].Attach(props[i], in.Chosen[i]);
    if (auto* const actor = vtkActor::SafeDownCast(props[i]))
    {
      wfv::ClassifyBlocksOf(actor->GetMapper(), s->GetRenderer()->GetRenderWindow());
    }
  }
  vtkRenderState seen(s->GetRenderer());
  seen.SetFrameBuffer(s->GetFrameBuffer());
  seen.SetRequiredKeys(s->GetRequiredKeys());
  seen.SetPropArrayAndCount(props, count);
  this->DrawDelegate(&seen);
  for (int i = 0; i < count; i++)
  {
    in.Keys[i].Detach(props[i], in.Chosen[i]);
  }
}

void vtkWideFoVPass::FindRelaxation(vtkRenderer* renderer)
{
  const double share = renderer->GetAllocatedRenderTime();
  const double took = renderer->GetLastRenderTimeInSeconds();
  if (!this->KeepUpdateRate || this->Technique == VERTEX || share > LongestShare)
  {
    this->Relaxation = 0; // it stands still
    return;
  }
  const int change = took > share ? 1 : took < SpareTime * share ? -1 : 0;
  this->Relaxation = std::clamp(this->Relaxation + change, 0, MostRelaxed);
}

bool vtkWideFoVPass::IsExact()
{
  return IsExactTechnique(this->Technique, this->Tolerance);
}

bool vtkWideFoVPass::IsExactTechnique(int technique, double tolerance)
{
  return vtkWideFoVStages::IsExactTechnique(technique, tolerance);
}

void vtkWideFoVPass::Render(const vtkRenderState* s)
{
  Internals& in = *this->Internal;
  vtkRenderer* renderer = s->GetRenderer();
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
    this->DrawDelegate(s);
    return;
  }
  wfv::WarnOfVtk();
  this->RenderWide(s, camera);
  this->TakeCounts();
}

void vtkWideFoVPass::RenderWide(const vtkRenderState* s, vtkWideFoVCamera* camera)
{
  Internals& in = *this->Internal;
  vtkRenderer* renderer = s->GetRenderer();
  const int count = s->GetPropArrayCount();
  vtkProp** props = s->GetPropArray();
  in.Props.Gather(renderer, props, count);
  double bounds[6];
  camera->BeginFrame(renderer, in.Props.GetSceneBounds(renderer, bounds) ? bounds : nullptr);
  in.Stages.SetCulling(this->Culling != 0);
  this->FindRelaxation(renderer);
  in.Stages.Begin(renderer, camera, this->Technique,
    std::max(this->Tolerance, RelaxedTolerances[this->Relaxation]));
  in.Stages.SetDebugView(this->DebugView != 0);
  in.Props.Choose(in.Stages, in.Stages.GetViewNumber());
  const int seen = this->Cull(props);
  this->NumberOfDrawnProps = seen;
  this->NumberOfCulledProps = count - seen;
  wfv::RendererAccess::SetCount(renderer, props, seen);
  this->Draws = true;
  this->DrawProps(s, props, seen);
  this->Draws = false;
  in.Texts.Draw(renderer, camera, in.Stages.Plain->GetTile());
  wfv::RendererAccess::SetCount(renderer, props, count);
  for (int i = 0; i < count; i++)
  {
    props[i] = in.Props.GetProp(i);
  }
  in.Stages.End();
  camera->EndFrame();
}

void vtkWideFoVPass::ResetCounts(int props)
{
  this->NumberOfPlainDraws = this->NumberOfPreClipDraws = 0;
  this->NumberOfExactDraws = this->NumberOfTessellateDraws = 0;
  this->NumberOfClusters = this->NumberOfCulledClusters = 0;
  this->NumberOfTriangles = this->NumberOfCulledTriangles = this->NumberOfProjectedTriangles = 0;
  this->NumberOfChosenProps = this->NumberOfClassifiedMeshes = 0;
  this->NumberOfCulledProps = 0;
  this->NumberOfDrawnProps = props;
}

void vtkWideFoVPass::TakeCounts()
{
  const vtkWideFoVStages& stages = this->Internal->Stages;
  this->NumberOfPlainDraws = stages.Plain->GetNumberOfDraws() + stages.Cut->GetNumberOfDraws();
  // of the tessellate stage too, what cannot be tessellated is drawn by the pre-clip
  const int patches = stages.Tessellate->GetNumberOfTessellateDraws();
  this->NumberOfPreClipDraws = stages.PreClip->GetNumberOfDraws() +
    stages.PreClipOfFew->GetNumberOfDraws() + stages.PreClipAtChords->GetNumberOfDraws() +
    stages.Tessellate->GetNumberOfDraws() - patches;
  this->NumberOfTessellateDraws = patches;
  this->NumberOfExactDraws =
    stages.Exact->GetNumberOfDraws() + stages.ExactInSingle->GetNumberOfDraws();
  this->NumberOfClusters = stages.Counts.Clusters;
  this->NumberOfCulledClusters = stages.Counts.UnseenClusters;
  this->NumberOfTriangles = stages.Counts.Triangles;
  this->NumberOfCulledTriangles = stages.Counts.UnseenTriangles;
  this->NumberOfProjectedTriangles = stages.Counts.ProjectedTriangles;
  this->NumberOfChosenProps = stages.Counts.ChosenProps;
  this->NumberOfClassifiedMeshes = stages.Counts.ClassifiedMeshes;
  this->NumberOfMadePrograms = stages.Shaders.GetNumberOfPrograms();
  this->ShaderTime = stages.Shaders.GetSeconds();
  this->ClusterTime = stages.ClusterTime.count();
}

void vtkWideFoVPass::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Internal->Stages.ReleaseGraphicsResources(window);
  if (this->Internal->Delegate)
  {
    this->Internal->Delegate->ReleaseGraphicsResources(window);
  }
  this->Superclass::ReleaseGraphicsResources(window);
}
