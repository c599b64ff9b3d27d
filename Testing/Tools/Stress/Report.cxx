// SPDX-License-Identifier: BSD-3-Clause
#include "Report.h"

#include <algorithm>

namespace wfv
{
namespace stress
{
namespace
{
// Failing batches that are described, of each projection, case and technique.
constexpr int MostFailures = 5;

Json ToObject(const std::map<std::pair<std::string, std::string>, Counts>& counts)
{
  Json json = Json::object();
  for (const auto& [key, count] : counts)
  {
    json[key.first][key.second] = ToJson(count);
  }
  return json;
}
}

void Report::AddFailure(const BatchId& id, const std::string& technique, const Json& result)
{
  if (++this->FailuresOf[id.Projection + " " + id.Case + " " + technique] > MostFailures)
  {
    return;
  }
  Batch batch;
  batch.Id = id;
  batch.Seed = std::uint64_t(this->Options.Seed);
  Json failure = { { "projection", id.Projection }, { "case", id.Case }, { "technique", technique },
    { "batch", id.Number },
    { "reproduce", Reproducer(batch, technique, this->Options.Tolerance) } };
  failure.update(result);
  this->Failures.push_back(failure);
}

void Report::Add(const BatchId& id, const Json& result)
{
  this->Primitives[id.Projection] += result.value("primitives", FindCase(id.Case)->Primitives);
  for (const std::string& technique : this->Options.Techniques)
  {
    Counts counts;
    const bool crashed = result.contains("crash");
    if (crashed)
    {
      counts.Crashes = technique == result["technique"].get<std::string>();
    }
    else
    {
      counts = FromJson(result["techniques"][technique]["counts"]);
    }
    this->Total.Add(counts);
    this->ByCase[{ id.Case, technique }].Add(counts);
    this->ByProjection[{ id.Projection, technique }].Add(counts);
    if (crashed && counts.Crashes > 0)
    {
      this->AddFailure(id, technique, { { "crash", result["crash"] } });
    }
    else if (counts.Failed())
    {
      this->AddFailure(id, technique,
        { { "shot", result["shot"] }, { "counts", stress::ToJson(counts) },
          { "lines", result["techniques"][technique]["lines"] } });
    }
  }
}

Json Report::ToJson() const
{
  long primitives = 0;
  for (const auto& [projection, count] : this->Primitives)
  {
    primitives = std::max(primitives, count); // the same for each
  }
  Json json = { { "primitives", primitives }, { "projections", this->Options.Projections },
    { "techniques", this->Options.Techniques }, { "seed", this->Options.Seed },
    { "tolerance", this->Options.Tolerance } };
  json.update(stress::ToJson(this->Total));
  json["by_case"] = ToObject(this->ByCase);
  json["by_projection"] = ToObject(this->ByProjection);
  json["failures"] = this->Failures;
  return json;
}
}
}
