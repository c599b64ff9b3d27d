// SPDX-License-Identifier: BSD-3-Clause
#include "Compat/StockText.h"

#include "Compat/Reports.h"
#include "WideFoVGlsl.h"

#include "vtkVersion.h"

#include <sstream>

namespace wfv
{
namespace stock
{
namespace
{
std::string Version(int number)
{
  return number == Unreleased
    ? "VTK after 9.7"
    : "VTK " + std::to_string(number / 100) + "." + std::to_string(number % 100);
}

std::string Sentence(Edit edit)
{
  const Entry& entry = Table()[static_cast<std::size_t>(edit)];
  std::ostringstream words;
  words << "the shaders of VTK " << vtkVersion::GetVTKVersion() << " have nothing for the edit \""
        << entry.Name << "\" (" << entry.Where << "), which looks for";
  for (const Wording& wording : entry.Wordings)
  {
    words << (&wording == &entry.Wordings.front() ? " " : " or ") << wording.Text << " ("
          << Version(wording.Since) << ")";
  }
  return words.str();
}
}

bool ReportMissing(
  vtkObject* object, vtkAbstractMapper* mapper, const std::string& texts, const char* instead)
{
  const std::vector<Edit> missing = Missing(texts);
  for (const Edit edit : missing)
  {
    if (IsNews(std::string("edit ") + Table()[static_cast<std::size_t>(edit)].Name))
    {
      const std::string words =
        Sentence(edit) + ": " + instead + " (first seen with a " + mapper->GetClassName() + ")";
      vtkErrorWithObjectMacro(object, << words);
    }
  }
  return !missing.empty();
}

void LeaveOutUnedited(vtkObject* object, vtkAbstractMapper* mapper, std::string& vertex,
  std::string& geometry, std::string& fragment)
{
  if (ReportMissing(
        object, mapper, vertex + geometry + fragment, "props that need this edit are not drawn"))
  {
    LeaveOut(vertex, geometry, fragment);
  }
}

void LeaveOut(std::string& vertex, std::string& geometry, std::string& fragment)
{
  vertex = nothing_vertex_glsl;
  geometry.clear();
  fragment = nothing_fragment_glsl;
}

bool DrawsNothing(const std::string& fragment)
{
  return fragment.find("wfvDrawsNothing") != std::string::npos;
}
}
}
