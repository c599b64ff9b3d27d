// SPDX-License-Identifier: BSD-3-Clause
// What is seen of data at each time: the scene, step after step.
#ifndef WideFoVFilmScenes_h
#define WideFoVFilmScenes_h

#include "Options/Options.h"
#include "Scenes/DataSeries.h"
#include "Scenes/Scene.h"

#include <vtkBoundingBox.h>

#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace widefov
{
class FilmScenes
{
public:
  // Reads what does not change, and of a series, unless --range is given, every step once for the
  // range of its colours. A step that cannot be read is said in a line. Throws a Failure with
  // ExitFailed where no step can be read, or one cannot and --strict is given.
  explicit FilmScenes(const Options& options);

  // Nothing where the data do not change.
  const std::optional<DataSeries>& GetSeries() const { return this->Series; }

  // 1 where the data do not change.
  std::size_t GetNumberOfSteps() const
  {
    return this->Series ? this->Series->GetSteps().size() : 1;
  }

  // The step that is seen when that share of the film, from 0 to below 1, is over.
  std::size_t StepAt(double share) const { return this->Series ? this->Series->StepAt(share) : 0; }

  // The step of --time.
  std::size_t GetFirstStep() const { return this->FirstStep; }

  // The scene of a step; of one that cannot be read that of the last before it that can, or else
  // of the first after it. It lasts until another one is asked for. A step that holds nothing is
  // empty. A step that lacks the array of the colours is grey, which one line says of the first.
  const Scene& GetScene(std::size_t step);

  // The scene of the first step that holds anything. Throws a Failure with ExitFailed if none does.
  const Scene& GetFirstFilled();

  // Round all steps where all were read, else round those that were, and the last.
  vtkBoundingBox FindBounds();

private:
  void CheckTime(const Options& options) const;
  void FindFiles(const Options& options);
  void FindRange();
  bool TryStep(std::size_t step);
  void TakeStep(std::size_t step);
  bool IsPlain(std::size_t step);
  void CheckArray();
  void SayLacking();
  void AddBounds();
  void SayComplaints();
  void Complain(std::size_t step, const std::string& complaint);
  Scene ReadStep(std::size_t step) const;

  widefov::Look Look;
  bool Strict;
  std::optional<DataSeries> Series;
  std::size_t FirstStep = 0;
  Scene Fixed; // what does not change, before it gets its look; all of it where nothing changes
  std::set<std::size_t> Broken;
  std::string FirstComplaint;
  bool SameComplaint = true; // of all broken steps
  std::vector<std::pair<std::size_t, std::string>> Untold;
  std::optional<std::size_t> Lacking; // first step read that has not the array of the colours
  std::string LackedArray;
  std::string LackComplaint;
  bool HasArray = false; // some step has it
  bool SaidLacking = false;
  Scene Bar;             // its bar: that of the steps with colours
  vtkBoundingBox Bounds; // of what was read
  bool AllRead = false;  // all steps, one after the other
  Scene Shown;
  std::optional<std::size_t> ShownStep;
};

// The scene that the options name; of data that change with time the step of --time. Throws a
// Failure with ExitFailed.
Scene LoadScene(const Options& options);
}

#endif
