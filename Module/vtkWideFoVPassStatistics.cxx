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
  AddLine(
    text, "props: %d drawn, %d left out", this->NumberOfDrawnProps, this->NumberOfCulledProps);
  AddLine(text, "clusters: %d, %d left out", this->NumberOfClusters, this->NumberOfCulledClusters);
  AddLine(text, "their triangles: %lld, %lld left out",
    static_cast<long long>(this->NumberOfTriangles),
    static_cast<long long>(this->NumberOfCulledTriangles));
  AddLine(
    text, "of those projected: %lld", static_cast<long long>(this->NumberOfProjectedTriangles));
  AddLine(text, "draws: plain %d, pre-clip %d, tessellate %d, exact %d", this->NumberOfPlainDraws,
    this->NumberOfPreClipDraws, this->NumberOfTessellateDraws, this->NumberOfExactDraws);
  AddLine(
    text, "anew: %d props, %d meshes", this->NumberOfChosenProps, this->NumberOfClassifiedMeshes);
  AddLine(text, "shaders: %d in %.1f ms", this->NumberOfMadePrograms, 1000 * this->ShaderTime);
  return text;
}
