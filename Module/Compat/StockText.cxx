// SPDX-License-Identifier: BSD-3-Clause
#include "Compat/StockText.h"

#include "Compat/Reports.h"
#include "WideFoVGlsl.h"

#include "vtkActor.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkLightingMapPass.h"
#include "vtkOpenGLHelper.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkOpenGLVertexBufferObjectGroup.h"
#include "vtkPlaneCollection.h"
#include "vtkProperty.h"
#include "vtkShaderProperty.h"
#include "vtkVersion.h"

#include <sstream>

namespace wfv
{
namespace stock
{
namespace
{
// What a pass may know of a mapper only from inside.
class TextAccess : public vtkOpenGLPolyDataMapper
{
public:
  static bool HasBuffer(vtkOpenGLPolyDataMapper* mapper, const char* name)
  {
    return (mapper->*(&TextAccess::VBOs))->GetNumberOfComponents(name) > 0;
  }

  static bool HasNormals(vtkOpenGLPolyDataMapper* mapper)
  {
    return HasBuffer(mapper, "normalMC") || mapper->*(&TextAccess::HaveCellNormals);
  }

  // As VTK counts: without a light nothing is lit, but by PBR.
  static Lit LightOf(vtkOpenGLPolyDataMapper* mapper, bool physical)
  {
    const auto& all = mapper->*(&TextAccess::PrimitiveInfo);
    const auto found = all.find(mapper->*(&TextAccess::LastBoundBO));
    if (found == all.end() || (!physical && found->second.LastLightCount == 0))
    {
      return Lit::No;
    }
    const int complexity = static_cast<int>(found->second.LastLightComplexity);
    return complexity <= 0 ? Lit::No : complexity == 1 ? Lit::Headlight : Lit::Otherwise;
  }
};

// Code or replacements of the user's own, and pictures of normals, which have no light.
bool IsForeign(vtkActor* actor)
{
  vtkInformation* const info = actor->GetPropertyKeys();
  vtkShaderProperty* const code = actor->GetShaderProperty();
  return code->HasVertexShaderCode() || code->HasFragmentShaderCode() ||
    code->HasGeometryShaderCode() || code->GetNumberOfShaderReplacements() > 0 ||
    (info && info->Has(vtkLightingMapPass::RENDER_NORMALS()));
}

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

Facts Describe(vtkAbstractMapper* mapper, vtkProp* prop)
{
  auto* const polydata = vtkOpenGLPolyDataMapper::SafeDownCast(mapper);
  auto* const actor = vtkActor::SafeDownCast(prop);
  Facts facts;
  if (!polydata || !actor)
  {
    return facts;
  }
  facts.Known = !IsForeign(actor);
  facts.Physical = actor->GetProperty()->GetInterpolation() == VTK_PBR;
  facts.Light = TextAccess::LightOf(polydata, facts.Physical);
  facts.Normals = TextAccess::HasNormals(polydata);
  facts.Wireframe = actor->GetProperty()->GetRepresentation() == VTK_WIREFRAME;
  facts.Glyphs = mapper->IsA("vtkOpenGLGlyph3DHelper");
  vtkPlaneCollection* const planes = mapper->GetClippingPlanes();
  facts.Clips = planes && planes->GetNumberOfItems() > 0;
  facts.Imposters = mapper->IsA("vtkOpenGLSphereMapper") || mapper->IsA("vtkOpenGLStickMapper") ||
    (mapper->IsA("vtkOpenGLPointGaussianMapperHelper") &&
      TextAccess::HasBuffer(polydata, "radiusMC"));
  return facts;
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
