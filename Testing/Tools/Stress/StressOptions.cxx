// SPDX-License-Identifier: BSD-3-Clause
#include "StressOptions.h"

#include "Frame/Stages.h"
#include "Frame/Technique.h"
#include "Text/Messages.h"
#include "Options/OptionGroup.h"

#include <CLI/CLI.hpp>

namespace wfv
{
namespace stress
{
namespace
{
// b of what is exact, pixels.
constexpr double ExactTolerance = 0.02;

std::vector<std::string> ProjectionNames()
{
  std::vector<std::string> names;
  for (const Projection& p : Projections())
  {
    names.push_back(p.Name);
  }
  return names;
}

std::vector<std::string> TechniqueNames()
{
  std::vector<std::string> names;
  for (const TechniqueEntry& technique : wfv::Techniques())
  {
    names.push_back(technique.Name);
  }
  return names;
}

void Declare(CLI::App& app, StressOptions& o)
{
  widefov::OptionGroup group(app, "Options");
  group.Name("--output", "FILE.json", o.Output, "what was counted");
  group.Integer("--primitives", o.Primitives, 1, 1000000000, "of each projection, at least");
  group.Integer("--seed", o.Seed, 0, 2147483647, "of the random numbers");
  group.Choices("--projections", o.Projections, ProjectionNames(), "projections");
  group.Choices("--technique", o.Techniques, TechniqueNames(), "techniques");
  group.Choices("--cases", o.Cases, CaseNames(), "kinds of primitives");
  group.Number("--tolerance", "PX", o.Tolerance, { 0.001, 1e6 },
    "of the techniques that have one, and what the ray caster explains within, pixels");
  group.Integer("--batch", o.Batch, 0, 1000000000, "this picture of each case alone");
  group.Flag("--version", o.Version, "print the version");
  app.add_flag("--worker", o.Worker)->group("");
  app.add_option("--skip", o.Skip)->group("");
  app.add_option("--abort-at", o.AbortAt)->group("");
}
}

std::optional<int> ParseStressOptions(int argc, char** argv, StressOptions& o)
{
  CLI::App app("Random primitives against the ray caster, as JSON.", "widefov-stress");
  o.Projections = ProjectionNames();
  o.Cases = CaseNames();
  Declare(app, o);
  if (const std::optional<int> done = widefov::ParseCommandLine(app, argc, argv))
  {
    return done;
  }
  if (o.Version)
  {
    widefov::Print("widefov-stress " WIDEFOV_VERSION "\n");
    return widefov::ExitDone;
  }
  if (o.Output.empty() && !o.Worker)
  {
    widefov::FailUsage("nothing to write; give --output FILE.json");
  }
  return std::nullopt;
}

std::vector<Technique> TechniquesOf(const StressOptions& o)
{
  std::vector<Technique> techniques;
  for (const std::string& name : o.Techniques)
  {
    const int number = FindTechnique(name);
    const double b = number == TechniqueExact ? ExactTolerance : o.Tolerance;
    const bool projects = number == TechniqueAuto && Stages::AllowsChords(o.Tolerance);
    techniques.push_back({ name, number, o.Tolerance, b, projects });
  }
  return techniques;
}

std::vector<BatchId> PlanOf(const StressOptions& o, const std::string& projection)
{
  if (o.Batch < 0)
  {
    return PlanBatches(projection, o.Cases, o.Primitives);
  }
  std::vector<BatchId> plan;
  for (const std::string& name : o.Cases)
  {
    plan.push_back({ projection, name, o.Batch });
  }
  return plan;
}
}
}
