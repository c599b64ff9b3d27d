// SPDX-License-Identifier: BSD-3-Clause
#include "SceneActor.h"

#include "Molecule.h"

#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkTexture.h>

#include <map>

namespace widefov
{
namespace
{
void SetColors(vtkPolyDataMapper* mapper, const SceneProp& prop)
{
  if (prop.Array.empty() && prop.Kind == SceneProp::Shape::Sticks)
  {
    mapper->SetScalarModeToUsePointFieldData();
    mapper->SelectColorArray(StickColor);
    mapper->SetColorModeToDirectScalars();
    return;
  }
  if (prop.Array.empty())
  {
    mapper->ScalarVisibilityOff();
    return;
  }
  mapper->ScalarVisibilityOn();
  if (prop.CellArray)
  {
    mapper->SetScalarModeToUseCellFieldData();
  }
  else
  {
    mapper->SetScalarModeToUsePointFieldData();
  }
  mapper->SelectColorArray(prop.Array.c_str());
  if (prop.Direct)
  {
    mapper->SetColorModeToDirectScalars();
    return;
  }
  mapper->SetColorModeToMapScalars();
  mapper->SetLookupTable(prop.ColorMap);
  mapper->UseLookupTableScalarRangeOn();
  // the colour of a place is that of its value, not a blend of its corners' colours
  mapper->SetInterpolateScalarsBeforeMapping(!prop.CellArray);
}

void SetRepresentation(vtkProperty* property, const std::string& name)
{
  if (name == "points")
  {
    property->SetRepresentationToPoints();
  }
  else if (name == "wireframe")
  {
    property->SetRepresentationToWireframe();
  }
  else
  {
    property->SetRepresentationToSurface();
    property->SetEdgeVisibility(name == "surface-with-edges");
  }
}

// VTK's name of the texture that gives the colour.
const char* const BaseColor = "albedoTex";

vtkSmartPointer<vtkTexture> CopyOf(vtkTexture* texture)
{
  auto copy = vtkSmartPointer<vtkTexture>::New();
  copy->SetInputData(texture->GetInput());
  copy->SetUseSRGBColorSpace(texture->GetUseSRGBColorSpace());
  copy->SetInterpolate(texture->GetInterpolate());
  copy->SetMipmap(texture->GetMipmap());
  copy->SetWrap(texture->GetWrap());
  return copy;
}

// With textures of its own: one belongs to one window. Colours by an array are in the place of
// those of the material, not times them.
void CopyMaterial(vtkProperty* material, bool itsColors, vtkProperty* property)
{
  std::map<std::string, vtkSmartPointer<vtkTexture>> textures;
  for (const auto& [name, texture] : material->GetAllTextures())
  {
    textures[name] = texture;
  }
  material->RemoveAllTextures(); // VTK 9.1 copies the pointers without counting them
  property->DeepCopy(material);
  property->SetEmissiveFactor(material->GetEmissiveFactor()); // which it forgets
  for (const auto& [name, texture] : textures)
  {
    material->SetTexture(name.c_str(), texture);
    property->SetTexture(name.c_str(), CopyOf(texture));
  }
  if (!itsColors)
  {
    property->RemoveTexture(BaseColor);
    property->SetColor(1, 1, 1);
  }
}
}

vtkSmartPointer<vtkActor> MakeActor(const SceneProp& prop, const Look& look)
{
  const vtkSmartPointer<vtkPolyDataMapper> mapper = MakeMapper(prop);
  mapper->SetInputData(prop.Surface);
  SetColors(mapper, prop);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  vtkProperty* const property = actor->GetProperty();
  if (prop.Material)
  {
    CopyMaterial(prop.Material->GetProperty(), prop.Array.empty() || prop.Direct, property);
    actor->SetForceTranslucent(prop.Material->GetForceTranslucent());
  }
  else
  {
    property->SetColor(prop.Color[0], prop.Color[1], prop.Color[2]);
    property->SetAmbient(prop.Ambient);
    property->SetDiffuse(prop.Diffuse);
  }
  property->SetLineWidth(static_cast<float>(look.LineWidth));
  property->SetPointSize(static_cast<float>(look.PointSize));
  property->SetRenderLinesAsTubes(look.LinesAsTubes);
  property->SetRenderPointsAsSpheres(look.PointsAsSpheres);
  property->SetFrontfaceCulling(prop.Inner);
  // else the rays of the volume end at pixels that the lines cover in part
  actor->SetForceTranslucent(
    prop.Kind == SceneProp::Shape::Outline || actor->GetForceTranslucent());
  SetRepresentation(property, look.Representation);
  return actor;
}
}
