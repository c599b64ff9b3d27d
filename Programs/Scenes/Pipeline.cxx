// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline.h"

#include "ColorMaps.h"
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
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>

namespace widefov
{
namespace
{
// Of a surface under arrows and stream lines: what they stand out from.
const Vector3 BackdropColor{ { 0.35, 0.35, 0.38 } };

// What --color-by names.
struct ArrayChoice
{
  std::string Name;
  int Component = -1; // -1: the magnitude
};

vtkDataArray* FindArray(vtkPolyData* data, const std::string& name, bool& isCell)
{
  isCell = false;
  if (vtkDataArray* const array = data->GetPointData()->GetArray(name.c_str()))
  {
    return array;
  }
  isCell = true;
  return data->GetCellData()->GetArray(name.c_str());
}

bool AnyHas(const Scene& scene, const std::string& name)
{
  bool isCell = false;
  return std::any_of(scene.Props.begin(), scene.Props.end(),
    [&](const SceneProp& prop) { return FindArray(prop.Surface, name, isCell) != nullptr; });
}

[[noreturn]] void FailNoArray(
  const Scene& scene, const std::string& option, const std::string& name)
{
  std::vector<std::string> names;
  for (const SceneProp& prop : scene.Props)
  {
    for (const std::string& other : ArrayNames(prop.Source))
    {
      if (std::find(names.begin(), names.end(), other) == names.end())
      {
        names.push_back(other);
      }
    }
  }
  Fail(option + ": the data have no array '" + name + "'; " +
    (names.empty() ? "they have none at all, so leave the option out"
                   : "choose one of " + Join(names)));
}

// "velocity:1", "velocity:y", "velocity:magnitude"; a name may itself hold a colon.
ArrayChoice ParseChoice(const Scene& scene, const std::string& text)
{
  const std::size_t colon = text.rfind(':');
  if (AnyHas(scene, text) || colon == std::string::npos)
  {
    return { text, -1 };
  }
  const std::string component = text.substr(colon + 1);
  const std::string axes = "xyzw";
  ArrayChoice choice{ text.substr(0, colon), -1 };
  if (component == "magnitude")
  {
    return choice;
  }
  const std::size_t axis = component.size() == 1
    ? axes.find(static_cast<char>(std::tolower(static_cast<unsigned char>(component[0]))))
    : std::string::npos;
  choice.Component = static_cast<int>(axis);
  const char* const end = component.data() + component.size();
  if (axis == std::string::npos)
  {
    const auto [stop, error] = std::from_chars(component.data(), end, choice.Component);
    if (error != std::errc() || stop != end || choice.Component < 0)
    {
      FailUsage("--color-by: '" + component +
        "' is no component; give a number from 0, x, y, z or magnitude");
    }
  }
  return choice;
}

struct ValueRange
{
  double Low = std::numeric_limits<double>::infinity();
  double High = -std::numeric_limits<double>::infinity();

  void Add(vtkDataArray* array, int component)
  {
    double range[2];
    array->GetFiniteRange(range, array->GetNumberOfComponents() == 1 ? 0 : component);
    if (range[0] <= range[1])
    {
      this->Low = std::min(this->Low, range[0]);
      this->High = std::max(this->High, range[1]);
    }
  }
};

vtkSmartPointer<vtkScalarsToColors> MapOf(const Look& look, const ValueRange& range, int component)
{
  const double low = look.Range ? (*look.Range)[0] : range.Low;
  const double high = look.Range ? (*look.Range)[1] : range.High;
  return MakeColorMap(look.ColorMap, low, high, component);
}

// Of what is drawn: the surface, or all that a volume is made of.
void AddRange(
  const SceneProp& prop, vtkDataArray* shown, const ArrayChoice& choice, ValueRange& range)
{
  range.Add(shown, choice.Component);
  if (prop.Kind != SceneProp::Shape::Volume)
  {
    return;
  }
  for (const auto& leaf : Leaves(prop.Source))
  {
    vtkDataArray* array = leaf->GetPointData()->GetArray(choice.Name.c_str());
    array = array != nullptr ? array : leaf->GetCellData()->GetArray(choice.Name.c_str());
    if (array != nullptr)
    {
      range.Add(array, choice.Component);
    }
  }
}

// Nobody asked for colours of this one: it is behind what has them, or holds its own.
bool KeepsColor(const SceneProp& prop, const Look& look)
{
  return look.ColorBy.empty() && prop.Kind != SceneProp::Shape::Volume &&
    (prop.Backdrop || prop.Direct || prop.Material);
}

// The colours by one array, over all props that have it: the others keep theirs grey.
void ColorBy(Scene& scene, const Look& look, const ArrayChoice& choice)
{
  ValueRange range;
  for (SceneProp& prop : scene.Props)
  {
    if (KeepsColor(prop, look))
    {
      continue;
    }
    vtkDataArray* const array = FindArray(prop.Surface, choice.Name, prop.CellArray);
    prop.Direct = false;
    prop.Array = array != nullptr ? choice.Name : "";
    if (array == nullptr)
    {
      continue;
    }
    if (choice.Component >= array->GetNumberOfComponents())
    {
      Fail("--color-by: the array '" + choice.Name + "' has " +
        std::to_string(array->GetNumberOfComponents()) + " components, counted from 0; component " +
        std::to_string(choice.Component) + " is not one of them");
    }
    AddRange(prop, array, choice, range);
  }
  if (!(range.Low <= range.High))
  {
    range.Low = 0; // nothing but NaN: drawn in the map's colour for it
    range.High = 1;
  }
  const auto map = MapOf(look, range, choice.Component);
  for (SceneProp& prop : scene.Props)
  {
    prop.ColorMap = map;
  }
  const bool usual = scene.FromFiles && look.ColorBy.empty() && look.UsualBar;
  scene.BarMap = look.ScalarBar || usual ? map : nullptr;
  scene.BarTitle = choice.Name;
}

// Bytes with three or four components are colours already.
bool HoldsColors(vtkDataArray* array)
{
  return vtkUnsignedCharArray::SafeDownCast(array) != nullptr &&
    array->GetNumberOfComponents() >= 3;
}

// The data's own scalars, where there are any and nothing else was asked for.
void ColorByOwnScalars(SceneProp& prop, const Look& look)
{
  vtkDataArray* scalars = prop.Surface->GetPointData()->GetScalars();
  prop.CellArray = scalars == nullptr;
  if (scalars == nullptr)
  {
    scalars = prop.Surface->GetCellData()->GetScalars();
  }
  if (scalars == nullptr || scalars->GetName() == nullptr)
  {
    return;
  }
  prop.Array = scalars->GetName();
  prop.Direct = HoldsColors(scalars);
  ValueRange range;
  range.Add(scalars, -1);
  if (!(range.Low <= range.High))
  {
    prop.Array.clear();
    return;
  }
  prop.ColorMap = MapOf(look, range, -1);
}

// As each prop holds them; props that have colours already keep them.
void ColorByOwnScalars(Scene& scene, const Look& look)
{
  for (SceneProp& prop : scene.Props)
  {
    if (prop.Array.empty())
    {
      ColorByOwnScalars(prop, look);
    }
  }
}

// Numbers that mean something and are not all the same, or may be others at another time.
bool Tells(vtkDataSetAttributes* attributes, vtkDataArray* array, const Look& look)
{
  if (array == nullptr || array->GetName() == nullptr || array->GetNumberOfComponents() != 1 ||
    array == attributes->GetGlobalIds() || array == attributes->GetPedigreeIds() ||
    std::string(array->GetName()) == vtkDataSetAttributes::GhostArrayName())
  {
    return false;
  }
  double range[2];
  array->GetFiniteRange(range, 0);
  return range[0] < range[1] || (look.OfSeries && range[0] == range[1]);
}

// The name of the active scalars, or else of the first array, that tell something.
std::string FirstScalars(vtkDataSetAttributes* attributes, const Look& look)
{
  if (Tells(attributes, attributes->GetScalars(), look))
  {
    return attributes->GetScalars()->GetName();
  }
  for (int i = 0; i < attributes->GetNumberOfArrays(); i++)
  {
    if (Tells(attributes, attributes->GetArray(i), look))
    {
      return attributes->GetArrayName(i);
    }
  }
  return "";
}

// Of files that nobody wants in any colours: one array gives all props theirs, so that one bar
// says what they mean. Those that hold colours keep them.
void ColorByFirstScalars(Scene& scene, const Look& look)
{
  std::string name;
  for (SceneProp& prop : scene.Props)
  {
    if (prop.Material)
    {
      continue;
    }
    ColorByOwnScalars(prop, look);
    if (!prop.Direct)
    {
      prop.Array.clear();
      name = name.empty() ? FirstScalars(prop.Surface->GetPointData(), look) : name;
    }
  }
  for (const SceneProp& prop : scene.Props)
  {
    name = name.empty() && !prop.Direct && !prop.Material
      ? FirstScalars(prop.Surface->GetCellData(), look)
      : name;
  }
  if (!name.empty())
  {
    ColorBy(scene, look, { name, -1 });
  }
}

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
      FailNoArray(scene, arrows ? "--vectors" : "--streamlines", name);
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
void ChooseColors(Scene& scene, const Look& look)
{
  const bool vectors = !look.Vectors.empty() || !look.StreamLines.empty();
  std::string name = look.ColorBy;
  if (name.empty() && vectors)
  {
    name = look.Vectors.empty() ? look.StreamLines : look.Vectors;
  }
  if (!name.empty())
  {
    const ArrayChoice choice = ParseChoice(scene, name);
    if (!AnyHas(scene, choice.Name))
    {
      FailNoArray(scene, "--color-by", choice.Name);
    }
    ColorBy(scene, look, choice);
  }
  else if (!scene.FromFiles)
  {
    ColorByOwnScalars(scene, look);
  }
  else if (look.Colors)
  {
    ColorByFirstScalars(scene, look);
  }
}
}

void ApplyLook(Scene& scene, const Look& look)
{
  ChooseVolumes(scene, look);
  if (!look.Vectors.empty() || !look.StreamLines.empty())
  {
    AddVectors(scene, look);
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
