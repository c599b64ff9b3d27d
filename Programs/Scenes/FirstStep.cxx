// SPDX-License-Identifier: BSD-3-Clause
#include "FirstStep.h"

#include "DataSeries.h"
#include "Readers.h"

#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>

namespace widefov
{
namespace
{
// A part is read as it is where it is the only one.
vtkSmartPointer<vtkDataObject> ReadParts(const std::vector<std::string>& files)
{
  if (files.size() == 1)
  {
    return ReadFile(files.front());
  }
  vtkNew<vtkMultiBlockDataSet> parts;
  for (const std::string& file : files)
  {
    parts->SetBlock(parts->GetNumberOfBlocks(), ReadFile(file));
  }
  return parts;
}
}

FirstStep ReadFirstStep(const std::string& path)
{
  const std::optional<DataSeries> series = DataSeries::Find(path);
  if (!series)
  {
    const vtkSmartPointer<vtkDataObject> data = ReadFile(path);
    return { data, TimesOf(data) };
  }
  FirstStep first;
  first.Data = ReadParts(series->GetSteps().front().Files);
  for (const TimeStep& step : series->GetSteps())
  {
    first.Times.push_back(step.Time);
  }
  return first;
}
}
