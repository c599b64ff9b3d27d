// SPDX-License-Identifier: BSD-3-Clause
#include "Info.h"

#include "Scenes/Datasets.h"
#include "Scenes/FirstStep.h"
#include "Scenes/Scene.h"
#include "Text/Messages.h"

#include <vtkAbstractArray.h>
#include <vtkBoundingBox.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkPointData.h>

#include <nlohmann/json.hpp>

#include <algorithm>

namespace widefov
{
namespace
{
using Json = nlohmann::ordered_json;

// One array of all the parts that have it.
struct ArrayFacts
{
  std::string Name;
  std::string Of; // points, cells, field
  std::string Type;
  int Components = 0;
  std::array<double, 2> Range{ { 1, 0 } }; // of the magnitude, where there are several
};

void Add(vtkFieldData* attributes, const std::string& of, std::vector<ArrayFacts>& all)
{
  for (int i = 0; i < attributes->GetNumberOfArrays(); i++)
  {
    vtkAbstractArray* const array = attributes->GetAbstractArray(i);
    const std::string name = array->GetName() != nullptr ? array->GetName() : "";
    auto known = std::find_if(all.begin(), all.end(),
      [&](const ArrayFacts& facts) { return facts.Name == name && facts.Of == of; });
    if (known == all.end())
    {
      all.push_back({ name, of, array->GetDataTypeAsString(), array->GetNumberOfComponents() });
      known = all.end() - 1;
    }
    auto* const numbers = vtkDataArray::SafeDownCast(array);
    double range[2] = { 1, 0 };
    if (numbers != nullptr)
    {
      numbers->GetFiniteRange(range, numbers->GetNumberOfComponents() == 1 ? 0 : -1);
    }
    if (range[0] <= range[1])
    {
      const bool first = known->Range[0] > known->Range[1];
      known->Range = { { first ? range[0] : std::min(range[0], known->Range[0]),
        first ? range[1] : std::max(range[1], known->Range[1]) } };
    }
  }
}

std::vector<ArrayFacts> ArraysOf(vtkDataObject* data)
{
  std::vector<ArrayFacts> all;
  const std::vector<vtkSmartPointer<vtkDataSet>> leaves = Leaves(data);
  for (const auto& leaf : leaves)
  {
    Add(leaf->GetPointData(), "points", all);
  }
  for (const auto& leaf : leaves)
  {
    Add(leaf->GetCellData(), "cells", all);
  }
  for (const auto& leaf : leaves)
  {
    Add(leaf->GetFieldData(), "field", all);
  }
  return all;
}

Json Describe(const ArrayFacts& facts)
{
  const bool known = facts.Range[0] <= facts.Range[1];
  return { { "name", facts.Name }, { "of", facts.Of }, { "type", facts.Type },
    { "components", facts.Components }, { "range", known ? Json(facts.Range) : Json(nullptr) } };
}

Json Describe(const std::string& file)
{
  const FirstStep first = ReadFirstStep(file);
  SceneProp prop;
  prop.Source = first.Data;
  prop.Surface = SurfaceOf(prop.Source);
  Scene scene;
  scene.Props.push_back(prop);
  vtkBoundingBox box;
  vtkIdType points = 0;
  vtkIdType cells = 0;
  const std::vector<vtkSmartPointer<vtkDataSet>> leaves = Leaves(prop.Source);
  for (const auto& leaf : leaves)
  {
    box.AddBounds(leaf->GetBounds());
    points += leaf->GetNumberOfPoints();
    cells += leaf->GetNumberOfCells();
  }
  Json bounds = nullptr; // of data without points
  if (box.IsValid() != 0)
  {
    std::array<double, 6> b{};
    box.GetBounds(b.data());
    bounds = b;
  }
  Json arrays = Json::array();
  for (const ArrayFacts& facts : ArraysOf(prop.Source))
  {
    arrays.push_back(Describe(facts));
  }
  return { { "file", file }, { "kind", prop.Source->GetClassName() }, { "parts", leaves.size() },
    { "points", points }, { "cells", cells },
    { "surface_triangles", CountPrimitives(scene).Triangles }, { "bounds", bounds },
    { "arrays", arrays }, { "times", first.Times } };
}

std::string Span(const Json& from, const Json& to)
{
  return Text(from.get<double>()) + " to " + Text(to.get<double>());
}

std::string ArrayLine(const Json& a)
{
  const int components = a["components"].get<int>();
  const std::string range = a["range"].is_null() ? "" : ", " + Span(a["range"][0], a["range"][1]);
  return "    " + a["name"].get<std::string>() + " (" + a["of"].get<std::string>() +
    "): " + a["type"].get<std::string>() +
    (components > 1 ? ", " + std::to_string(components) + " components, magnitude" : "") + range +
    "\n";
}

std::string TimesLine(const Json& times)
{
  if (times.empty())
  {
    return "  time steps: none\n";
  }
  return "  time steps: " + std::to_string(times.size()) + ", " +
    Span(times.front(), times.back()) + (times.size() > 1 ? "; all else is of the first\n" : "\n");
}

std::string TextOf(const Json& file)
{
  const Json& b = file["bounds"];
  std::string text = file["file"].get<std::string>() +
    "\n  kind: " + file["kind"].get<std::string>() + ", parts: " + file["parts"].dump() +
    "\n  points: " + file["points"].dump() + ", cells: " + file["cells"].dump() +
    ", triangles of the surface: " + file["surface_triangles"].dump() + "\n  bounds: " +
    (b.is_null()
        ? "none"
        : "x " + Span(b[0], b[1]) + ", y " + Span(b[2], b[3]) + ", z " + Span(b[4], b[5])) +
    "\n" + TimesLine(file["times"]) + (file["arrays"].empty() ? "  arrays: none\n" : "  arrays:\n");
  for (const Json& array : file["arrays"])
  {
    text += ArrayLine(array);
  }
  return text;
}
}

std::string InfoText(const Options& o)
{
  if (!o.Info)
  {
    return "";
  }
  Json all = Json::array();
  std::string text;
  for (const std::string& file : o.Files)
  {
    all.push_back(Describe(file));
    text += TextOf(all.back());
  }
  // names are what bytes the files have
  const auto replace = Json::error_handler_t::replace;
  return o.Json ? Json{ { "files", all } }.dump(2, ' ', false, replace) + "\n" : text;
}
}
