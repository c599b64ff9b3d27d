// SPDX-License-Identifier: BSD-3-Clause
#include "RenderStats.h"

#include <vtkWideFoVPass.h>

namespace widefov
{
void TakeCounts(vtkWideFoVPass* pass, int others, RenderStats& stats)
{
  stats.PropsDrawn = pass->GetNumberOfDrawnProps() - others;
  stats.PropsCulled = pass->GetNumberOfCulledProps();
  stats.Clusters = pass->GetNumberOfClusters();
  stats.ClustersCulled = pass->GetNumberOfCulledClusters();
  stats.Triangles = pass->GetNumberOfTriangles();
  stats.TrianglesCulled = pass->GetNumberOfCulledTriangles();
  stats.TrianglesProjected = pass->GetNumberOfProjectedTriangles();
  stats.ChosenProps = pass->GetNumberOfChosenProps();
  stats.ClassifiedMeshes = pass->GetNumberOfClassifiedMeshes();
  stats.PlainDraws = pass->GetNumberOfProjectedDraws();
  stats.PreClipDraws = pass->GetNumberOfPreClipDraws();
  stats.TessellateDraws = pass->GetNumberOfTessellateDraws();
  stats.ExactDraws = pass->GetNumberOfExactDraws();
}

void TakeShaders(vtkWideFoVPass* pass, int programsAtFirst, RenderStats& stats)
{
  ShaderCost& shaders = stats.Shaders;
  shaders.Programs = pass->GetNumberOfMadePrograms();
  shaders.Milliseconds = 1000 * pass->GetShaderTime();
  if (shaders.FirstFrame)
  {
    shaders.Later = *shaders.Programs - programsAtFirst;
  }
  stats.Parts.Shaders = shaders.Milliseconds;
  stats.Parts.Clusters = 1000 * pass->GetClusterTime();
}
}
