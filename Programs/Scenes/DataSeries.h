// SPDX-License-Identifier: BSD-3-Clause
// Data that change with time: which file holds which step.
#ifndef WideFoVDataSeries_h
#define WideFoVDataSeries_h

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace widefov
{
struct TimeStep
{
  double Time = 0;
  std::vector<std::string> Files; // the parts of the step
  int Index = -1;                 // of the step in its one file; -1: the file holds no other
};

// Steps in the order of their times.
class DataSeries
{
public:
  DataSeries(std::string name, std::vector<TimeStep> steps);

  // The series that a name on the command line stands for: .pvd, .series of any format, numbered
  // files (flow_%04d.vtp), .ex2 and .case with several steps. Nothing where it is a file without
  // steps. Throws a Failure with ExitFailed where the list is damaged or empty.
  static std::optional<DataSeries> Find(const std::string& path);

  // A step each file, in the order given.
  static DataSeries OfFiles(const std::vector<std::string>& paths);

  const std::string& GetName() const { return this->Name; }
  const std::vector<TimeStep>& GetSteps() const { return this->Steps; }

  // The step that is seen when that share of the whole, from 0 to below 1, is over. Times that
  // differ by more are seen longer; the last step is seen as long as one is on the average.
  std::size_t StepAt(double share) const;

  // The step that is seen at that time: the last one that is not after it, or else the first.
  std::size_t StepFor(double time) const;

  // The share of the whole for which a step is seen, by StepAt.
  double ShareOf(std::size_t step) const;

private:
  std::string Name;
  std::vector<TimeStep> Steps;
};
}

#endif
