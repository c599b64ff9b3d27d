// SPDX-License-Identifier: BSD-3-Clause
#include "ColorChoice.h"

#include "ColorMaps.h"
#include "Datasets.h"
#include "Text/Messages.h"
#include "Text/OptionValues.h"

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
void LackArray(Scene& scene, const Look& look, const std::string& option, const std::string& name)
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
  scene.Lacks = name;
  scene.Complaint = option + ": the data have no array '" + name + "'; " +
    (names.empty() ? "they have none at all, so leave the option out"
                   : "choose one of " + Join(names));
  if (!look.OfSeries)
  {
    Fail(scene.Complaint);
  }
}

namespace
{
// The array that --color-by names.
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

// Adds the range of the data that are drawn: of the surface, or of the whole volume.
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

// Colours by the names that scanners and ParaView give them, which need not be the active scalars.
vtkDataArray* NamedColors(vtkDataSetAttributes* attributes)
{
  for (int i = 0; i < attributes->GetNumberOfArrays(); i++)
  {
    vtkDataArray* const array = attributes->GetArray(i);
    const std::string name = array && array->GetName() ? array->GetName() : "";
    if ((name == "RGB" || name == "RGBA" || name == "Colors") && HoldsColors(array))
    {
      return array;
    }
  }
  return nullptr;
}

// The active scalars of the points or else of the cells; of files colours by their name before.
vtkDataArray* OwnScalars(SceneProp& prop, bool fromFiles)
{
  vtkPointData* const points = prop.Surface->GetPointData();
  vtkCellData* const cells = prop.Surface->GetCellData();
  vtkDataArray* const all[] = { fromFiles ? NamedColors(points) : nullptr,
    fromFiles ? NamedColors(cells) : nullptr, points->GetScalars(), cells->GetScalars() };
  for (int i = 0; i < 4; i++)
  {
    prop.CellArray = i % 2 == 1;
    if (all[i] != nullptr)
    {
      return all[i];
    }
  }
  return nullptr;
}

// The data's own scalars, where there are any and nothing else was asked for.
void ColorByOwnScalars(SceneProp& prop, bool fromFiles, const Look& look)
{
  vtkDataArray* const scalars = OwnScalars(prop, fromFiles);
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
      ColorByOwnScalars(prop, false, look);
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

// The first scalars of the data that are drawn. The whole volume is asked, because its border may
// have one value alone.
std::string FirstScalars(const SceneProp& prop, bool ofCells, const Look& look)
{
  vtkDataSet* drawn = prop.Surface;
  if (prop.Kind == SceneProp::Shape::Volume && vtkDataSet::SafeDownCast(prop.Source))
  {
    drawn = vtkDataSet::SafeDownCast(prop.Source);
  }
  return ofCells ? FirstScalars(drawn->GetCellData(), look)
                 : FirstScalars(drawn->GetPointData(), look);
}

// Colours all props by one array where no option chose colours, so that one bar explains them.
// Props whose data hold colours keep these.
void ColorByFirstScalars(Scene& scene, const Look& look)
{
  std::string name = look.UsualArray;
  for (SceneProp& prop : scene.Props)
  {
    if (prop.Material)
    {
      continue;
    }
    ColorByOwnScalars(prop, true, look);
    if (!prop.Direct)
    {
      prop.Array.clear();
      name = name.empty() ? FirstScalars(prop, false, look) : name;
    }
  }
  for (const SceneProp& prop : scene.Props)
  {
    name = name.empty() && !prop.Direct && !prop.Material ? FirstScalars(prop, true, look) : name;
  }
  if (!name.empty())
  {
    ColorBy(scene, look, { name, -1 });
  }
  if (!look.UsualArray.empty() && !AnyHas(scene, name))
  {
    scene.Lacks = name;
  }
}
}

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
      LackArray(scene, look, "--color-by", choice.Name);
      return;
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
