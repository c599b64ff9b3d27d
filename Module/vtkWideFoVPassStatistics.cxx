// SPDX-License-Identifier: BSD-3-Clause
// vtkWideFoVPass: what it counted, as text.
#include "vtkWideFoVPass.h"

#include <cstdarg>
#include <cstdio>

namespace
{
void AddLine(std::string& text, const char* format, ...)
{
  char line[160];
  va_list values;
  va_start(values, format);
  std::vsnprintf(line, sizeof(line), format, values);
  va_end(values);
  text += (text.empty() ? "" : "\n") + std::string(line);
}
}

std::string vtkWideFoVPass::GetStatistics()
{
  if (this->Draws)
  {
    this->TakeCounts();
  }
  std::string text;
  AddLine(text, "%s, tolerance %g px%s", GetTechniqueAsString(this->Technique), this->Tolerance,
    this->Relaxation > 0 ? ", relaxed" : "");
  const wfv::FrameStatistics& f = this->Figures;
  const auto count = [](vtkIdType n) { return static_cast<long long>(n); };
  AddLine(text, "props: %d drawn, %d left out", f.DrawnProps, f.CulledProps);
  AddLine(text, "clusters: %d, %d left out", f.Clusters, f.CulledClusters);
  AddLine(
    text, "their triangles: %lld, %lld left out", count(f.Triangles), count(f.CulledTriangles));
  AddLine(text, "as they are: %lld, pieces of others: %lld", count(f.ProjectedTriangles),
    count(f.Pieces));
  AddLine(text, "refined in %.1f ms", 1000 * f.RefineTime);
  AddLine(text, "draws: projected %d, pre-clip %d, tessellate %d, exact %d", f.ProjectedDraws,
    f.PreClipDraws, f.TessellateDraws, f.ExactDraws);
  AddLine(text, "anew: %d props, %d meshes", f.ChosenProps, f.ClassifiedMeshes);
  AddLine(text, "shaders: %d in %.1f ms", f.MadePrograms, 1000 * f.ShaderTime);
  return text;
}
