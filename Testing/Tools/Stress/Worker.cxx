// SPDX-License-Identifier: BSD-3-Clause
#include "Worker.h"

#include "System/Display.h"
#include "Text/Messages.h"

#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkRenderWindow.h>

#include <cstdlib>

namespace wfv
{
namespace stress
{
namespace
{
void Print(const Json& json)
{
  widefov::Print(json.dump() + "\n");
}

// `number` is that of the batch in the plan.
Json CheckBatch(Checker& checker, const Batch& batch, const StressOptions& o, std::size_t number)
{
  Json techniques = Json::object();
  checker.SetBatch(batch);
  for (const Technique& technique : TechniquesOf(o))
  {
    Print({ { "begin", number }, { "technique", technique.Name } });
    if (o.AbortAt >= 0 && std::size_t(o.AbortAt) == number)
    {
      std::abort();
    }
    const Verdict verdict = checker.Check(technique);
    Json lines = Json::array();
    for (const std::string& line : verdict.Lines)
    {
      lines.push_back(line);
    }
    techniques[technique.Name] = { { "counts", ToJson(verdict.Count) }, { "lines", lines } };
  }
  return { { "primitives", batch.What.Mesh->GetNumberOfCells() },
    { "shot", test::Describe(batch.Shot) }, { "techniques", techniques } };
}
}

int RunWorker(const StressOptions& o)
{
  const widefov::DisplayConnection display;
  {
    vtkNew<vtkRenderWindow> window;
    widefov::OpenWindow(window); // complains where OpenGL is too old
  }
  const std::vector<BatchId> plan = PlanOf(o, o.Projections.front());
  Checker checker;
  for (std::size_t i = std::size_t(o.Skip); i < plan.size(); ++i)
  {
    Json result = CheckBatch(checker, MakeBatch(plan[i], std::uint64_t(o.Seed)), o, i);
    result["done"] = i;
    Print(result);
  }
  Print({ { "end", plan.size() } });
  return widefov::ExitDone;
}
}
}
