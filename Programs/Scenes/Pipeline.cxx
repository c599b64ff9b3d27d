// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline.h"

#include "ColorChoice.h"
#include "Datasets.h"
#include "Molecule.h"
#include "Readers.h"
#include "System/Progress.h"
#include "Text/Messages.h"
#include "Text/OptionValues.h"
#include "VectorField.h"
#include "Volume.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>

#include <algorithm>

namespace widefov
{
namespace
{
// Of a surface under arrows and stream lines: what they stand out from.
const Vector3 BackdropColor{ { 0.35, 0.35, 0.38 } };

bool HasVectors(vtkDataObject* data, const std::string& name)
{
  for (const auto& leaf : Leaves(data))
  {
    vtkDataArray* array = leaf->GetPointData()->GetArray(name.c_str());
    if (array == nullptr)
    {
      array = leaf->GetCellData()->GetArray(name.c_str());
    }
    if (array != nullptr)
    {
      if (array->GetNumberOfComponents() != 3)
      {
        Fail("the array '" + name + "' has " + std::to_string(array->GetNumberOfComponents()) +
          " components; arrows and stream lines need 3");
      }
      return true;
    }
  }
  return false;
}

// The surfaces of the props, behind what is drawn of their vectors. Of data that fill space the
// inner sides alone: the outer ones would hide it all.
std::vector<SceneProp> Backdrops(const Scene& scene, const Look& look)
{
  std::vector<SceneProp> backdrops = look.Surface ? scene.Props : std::vector<SceneProp>();
  for (SceneProp& prop : backdrops)
  {
    prop.Backdrop = true;
    prop.Inner = FillsSpace(prop.Source);
    prop.Color = BackdropColor;
  }
  return backdrops;
}

// Arrows and tubes of the props that have the array, and what is to stay of the props.
void AddVectors(Scene& scene, const Look& look)
{
  std::vector<SceneProp> all = Backdrops(scene, look);
  for (const auto& [name, arrows] :
    { std::make_pair(look.Vectors, true), std::make_pair(look.StreamLines, false) })
  {
    if (name.empty())
    {
      continue;
    }
    bool found = false;
    for (const SceneProp& prop : scene.Props)
    {
      if (HasVectors(prop.Source, name))
      {
        const Progress progress((arrows ? "arrows of " : "stream lines of ") + prop.Label);
        found = true;
        all.push_back(prop);
        all.back().Kind = SceneProp::Shape::Mesh;
        all.back().InSpace = FillsSpace(prop.Source);
        all.back().Surface = arrows ? MakeArrows(prop.Source, name, ArrowSettings())
                                    : MakeStreamTubes(prop.Source, name, TubeSettings());
      }
    }
    if (!found)
    {
      LackArray(scene, look, arrows ? "--vectors" : "--streamlines", name);
    }
  }
  scene.Props = all;
}
}

namespace
{
// Molecules as balls and sticks; a point or a line they are where that is asked for.
void ReplaceMolecules(Scene& scene, const Look& look)
{
  if (look.Representation != "surface")
  {
    return;
  }
  std::vector<SceneProp> replaced;
  for (const SceneProp& prop : scene.Props)
  {
    const std::vector<SceneProp> parts =
      IsMolecule(prop) ? BallsAndSticks(prop) : std::vector<SceneProp>{ prop };
    replaced.insert(replaced.end(), parts.begin(), parts.end());
  }
  scene.Props = replaced;
}
}

namespace
{
// Leaves out props without cells. An empty time step is an empty picture; other data say so.
void LeaveOutEmpty(Scene& scene, const Look& look)
{
  std::vector<SceneProp> filled;
  std::vector<std::string> empty;
  for (const SceneProp& prop : scene.Props)
  {
    if (prop.Surface->GetNumberOfCells() > 0 || !scene.FromFiles)
    {
      filled.push_back(prop);
    }
    else if (empty.empty() || empty.back() != prop.Label)
    {
      empty.push_back(prop.Label);
    }
  }
  if (filled.empty() && !empty.empty() && !look.OfSeries)
  {
    Fail(Join(empty) + ": no points or cells; there is nothing to draw, so check the data");
  }
  for (const std::string& label : look.OfSeries ? std::vector<std::string>() : empty)
  {
    Say(label + " has no points or cells, and is left out");
  }
  scene.Props = filled;
}
}

void ApplyLook(Scene& scene, const Look& look)
{
  LeaveOutEmpty(scene, look);
  if (scene.Props.empty())
  {
    return;
  }
  ChooseVolumes(scene, look);
  if (!look.Vectors.empty() || !look.StreamLines.empty())
  {
    AddVectors(scene, look);
    LeaveOutEmpty(scene, look);
  }
  for (SceneProp& prop : scene.Props)
  {
    DropUnusable(prop);
  }
  ReplaceMolecules(scene, look);
  ChooseColors(scene, look);
  TakeVolumes(scene);
}
}
