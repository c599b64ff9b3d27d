// SPDX-License-Identifier: BSD-3-Clause
#include "ArrayList.h"

#include "Datasets.h"
#include "FirstStep.h"
#include "Text/Messages.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace widefov
{
namespace
{
using Json = nlohmann::ordered_json;

struct ArrayEntry
{
  const char* Of; // points or cells
  std::string Name;
  int Components;
  std::string Type;
  double Low = std::numeric_limits<double>::infinity(); // of the value, or of the length
  double High = -std::numeric_limits<double>::infinity();
};

// The blocks of composite data are taken together.
void Collect(const char* of, vtkDataSetAttributes* attributes, std::vector<ArrayEntry>& all)
{
  for (int i = 0; i < attributes->GetNumberOfArrays(); i++)
  {
    vtkDataArray* const array = attributes->GetArray(i);
    if (array == nullptr || array->GetName() == nullptr)
    {
      continue;
    }
    const std::string name = array->GetName();
    auto entry = std::find_if(all.begin(), all.end(),
      [&](const ArrayEntry& e) { return e.Name == name && std::string(e.Of) == of; });
    if (entry == all.end())
    {
      all.push_back({ of, name, array->GetNumberOfComponents(), array->GetDataTypeAsString() });
      entry = all.end() - 1;
    }
    double range[2];
    array->GetFiniteRange(range, array->GetNumberOfComponents() == 1 ? 0 : -1);
    if (range[0] <= range[1]) // otherwise there is no finite value
    {
      entry->Low = std::min(entry->Low, range[0]);
      entry->High = std::max(entry->High, range[1]);
    }
  }
}

bool HasRange(const ArrayEntry& entry)
{
  return entry.Low <= entry.High;
}

std::string TextOf(const ArrayEntry& entry)
{
  return std::string(entry.Of) + "  " + entry.Name + "  " + entry.Type +
    (entry.Components > 1 ? " x " + std::to_string(entry.Components) : "") + "  " +
    (HasRange(entry) ? Text(entry.Low) + " to " + Text(entry.High) : "no finite value") + "\n";
}

Json Describe(const ArrayEntry& entry)
{
  return { { "name", entry.Name }, { "of", entry.Of }, { "type", entry.Type },
    { "components", entry.Components },
    { "range", HasRange(entry) ? Json{ entry.Low, entry.High } : Json(nullptr) } };
}
}

std::string ArrayListOf(const std::string& path, bool json)
{
  const vtkSmartPointer<vtkDataObject> data = ReadFirstStep(path).Data;
  std::vector<ArrayEntry> all;
  for (const auto& leaf : Leaves(data))
  {
    Collect("points", leaf->GetPointData(), all);
  }
  for (const auto& leaf : Leaves(data))
  {
    Collect("cells", leaf->GetCellData(), all);
  }
  Json list = Json::array();
  std::string text;
  for (const ArrayEntry& entry : all)
  {
    list.push_back(Describe(entry));
    text += TextOf(entry);
  }
  return json ? list.dump(2) + "\n" : text;
}
}
