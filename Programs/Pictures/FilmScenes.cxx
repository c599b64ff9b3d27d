// SPDX-License-Identifier: BSD-3-Clause
#include "FilmScenes.h"

#include "LoadScene.h"
#include "Scenes/Pipeline.h"
#include "Scenes/Readers.h"
#include "System/MessageCatcher.h"
#include "System/Progress.h"
#include "Text/Messages.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace widefov
{
namespace
{
bool HasColors(const SceneProp& prop)
{
  return !prop.Array.empty() && !prop.Direct && prop.ColorMap;
}

// The range of the colours. False where props have the colours of different arrays.
bool AddRange(const Scene& scene, std::array<double, 2>& range)
{
  std::string array;
  for (const SceneProp& prop : scene.Props)
  {
    if (!HasColors(prop))
    {
      continue;
    }
    if (!array.empty() && array != prop.Array)
    {
      return false;
    }
    array = prop.Array;
    const double* const own = prop.ColorMap->GetRange();
    range = { { std::min(range[0], own[0]), std::max(range[1], own[1]) } };
  }
  return true;
}
}

FilmScenes::FilmScenes(const Options& o)
  : Look(LookOf(o))
  , Strict(o.Film.Strict)
{
  this->FindFiles(o);
  if (!this->Series)
  {
    this->Shown = LoadFixed(o);
    this->ShownStep = 0;
    this->AddBounds();
  }
  else if (o.Time)
  {
    this->FirstStep = this->Series->StepFor(*o.Time);
  }
  this->Look.OfSeries = this->Series.has_value();
  if (this->Series && !this->Look.Range)
  {
    this->FindRange();
  }
  if (this->Series)
  {
    this->CheckArray();
  }
}

void FilmScenes::CheckTime(const Options& o) const
{
  const bool film = o.Film.Kind == "time";
  if (!this->Series && (film || o.Time))
  {
    FailUsage(std::string(film ? "--film time" : "--time") +
      " needs data that change with time: a .pvd or .series file, " +
      (film ? "several files, " : "") +
      "numbered files such as flow_%04d.vtp, or an .ex2 file with several steps");
  }
}

void FilmScenes::FindFiles(const Options& o)
{
  std::vector<std::string> fixed;
  for (const std::string& path : o.Files)
  {
    std::optional<DataSeries> series = DataSeries::Find(path);
    if (!series)
    {
      fixed.push_back(path);
      continue;
    }
    if (this->Series)
    {
      Fail(path + " and " + this->Series->GetName() +
        " both change with time; give one of them, or join them in a .pvd file");
    }
    this->Series = series;
  }
  if (!this->Series && o.Film.Kind == "time" && fixed.size() > 1)
  {
    this->Series = DataSeries::OfFiles(fixed);
    fixed.clear();
  }
  this->CheckTime(o);
  if (this->Series)
  {
    this->Fixed = ReadScene(fixed);
  }
}

Scene FilmScenes::ReadStep(std::size_t number) const
{
  const TimeStep& step = this->Series->GetSteps()[number];
  Scene moving =
    ReadScene(step.Files, step.Index > 0 ? std::optional<double>(step.Time) : std::nullopt);
  Scene scene = this->Fixed;
  for (SceneProp& prop : moving.Props)
  {
    prop.Index += static_cast<int>(this->Fixed.Props.size());
    scene.Props.push_back(prop);
  }
  Prepare(scene, this->Look);
  return scene;
}

bool FilmScenes::TryStep(std::size_t step)
{
  if (this->ShownStep == step)
  {
    return true;
  }
  if (this->Broken.count(step) > 0)
  {
    return false;
  }
  try
  {
    this->Shown = this->ReadStep(step);
    this->TakeStep(step);
    this->AddBounds();
    this->SayComplaints();
    return true;
  }
  catch (const Failure& failure)
  {
    if (this->Strict)
    {
      throw;
    }
    this->Complain(step, failure.what());
    return false;
  }
}

// Notes what the step says of the others: the array of the colours, and the bar, which is seen
// over empty steps, too.
void FilmScenes::TakeStep(std::size_t step)
{
  this->ShownStep = step;
  if (!this->Shown.Lacks.empty() && !this->Lacking)
  {
    this->Lacking = step;
    this->LackedArray = this->Shown.Lacks;
    this->LackComplaint = this->Shown.Complaint;
  }
  this->HasArray = this->HasArray || (this->Shown.Lacks.empty() && !this->Shown.Props.empty());
  if (this->Series && this->Look.ColorBy.empty() && this->Look.UsualArray.empty() &&
    this->Look.Vectors.empty() && this->Look.StreamLines.empty())
  {
    this->Look.UsualArray = this->Shown.BarTitle;
  }
  if (this->Shown.BarMap)
  {
    this->Bar.BarMap = this->Shown.BarMap;
    this->Bar.BarTitle = this->Shown.BarTitle;
  }
  else if (this->Look.Range)
  {
    this->Shown.BarMap = this->Bar.BarMap;
    this->Shown.BarTitle = this->Bar.BarTitle;
  }
  this->SayLacking();
}

void FilmScenes::SayLacking()
{
  if (this->HasArray && this->Lacking && !this->SaidLacking)
  {
    this->SaidLacking = true;
    Say("time step " + std::to_string(*this->Lacking) + " has no array '" + this->LackedArray +
      "' and is drawn without it, as is every other step that has none");
  }
}

// Reads steps until one has the array that was asked for.
void FilmScenes::CheckArray()
{
  for (std::size_t i = 0; i < this->GetNumberOfSteps() && this->Lacking && !this->HasArray; i++)
  {
    this->TryStep(i);
  }
  if (this->Lacking && !this->HasArray)
  {
    Fail(this->LackComplaint);
  }
}

bool FilmScenes::IsPlain(std::size_t step)
{
  return this->TryStep(step) && !this->Shown.Props.empty() && this->Shown.Lacks.empty() &&
    std::none_of(this->Shown.Props.begin(), this->Shown.Props.end(), HasColors);
}

void FilmScenes::AddBounds()
{
  double b[6];
  if (SceneBounds(this->Shown, b))
  {
    this->Bounds.AddBounds(b);
  }
}

// One line says it where no step can be read: so lines of steps wait for one that can.
void FilmScenes::Complain(std::size_t step, const std::string& complaint)
{
  this->FirstComplaint = this->Broken.empty() ? complaint : this->FirstComplaint;
  this->SameComplaint = this->SameComplaint && complaint == this->FirstComplaint;
  this->Broken.insert(step);
  this->Untold.emplace_back(step, complaint);
  if (this->Bounds.IsValid() != 0)
  {
    this->SayComplaints();
  }
}

void FilmScenes::SayComplaints()
{
  if (this->Lacking && !this->HasArray)
  {
    return; // one line says it if no step has the array
  }
  for (const auto& [step, complaint] : this->Untold)
  {
    Say("time step " + std::to_string(step) +
      " is left out, and its frames show another: " + complaint);
  }
  this->Untold.clear();
}

void FilmScenes::FindRange()
{
  Progress progress("finding the range of the colours in all time steps; --range A,B saves it");
  std::array<double, 2> range{ { HUGE_VAL, -HUGE_VAL } };
  const std::size_t count = this->GetNumberOfSteps();
  // what both ends complain of in the same words, such as an array that is not there, is said
  // before those between are read
  if (count > 2 && !this->TryStep(0) && !this->TryStep(count - 1) && this->SameComplaint)
  {
    Fail(this->FirstComplaint);
  }
  if (this->IsPlain(0) && this->IsPlain(count - 1))
  {
    return; // no step has colours
  }
  for (std::size_t i = 0; i < count; i++)
  {
    if (this->TryStep(i) && !AddRange(this->Shown, range))
    {
      return; // each has its own colours
    }
    progress.Update(static_cast<double>(i + 1) / static_cast<double>(count));
  }
  this->AllRead = true;
  if (range[0] < range[1])
  {
    this->Look.Range = range;
    this->ShownStep.reset(); // it was drawn in its own range
  }
}

const Scene& FilmScenes::GetScene(std::size_t step)
{
  for (std::size_t i = step + 1; i-- > 0;)
  {
    if (this->TryStep(i))
    {
      return this->Shown;
    }
  }
  for (std::size_t i = step + 1; i < this->GetNumberOfSteps(); i++)
  {
    if (this->TryStep(i))
    {
      return this->Shown;
    }
  }
  // the same trouble with all is that of the command line
  Fail(this->SameComplaint
      ? this->FirstComplaint
      : "no time step can be read; the first complaint: " + this->FirstComplaint);
}

const Scene& FilmScenes::GetFirstFilled()
{
  for (std::size_t i = 0; i < this->GetNumberOfSteps(); i++)
  {
    if (!this->GetScene(i).Props.empty())
    {
      return this->Shown;
    }
  }
  Fail(this->Series->GetName() + ": no time step has points or cells; there is nothing to draw");
}

vtkBoundingBox FilmScenes::FindBounds()
{
  if (!this->AllRead)
  {
    this->GetScene(this->GetNumberOfSteps() - 1);
  }
  return this->Bounds;
}

Scene LoadScene(const Options& options)
{
  FilmScenes scenes(options);
  const Scene scene = scenes.GetScene(scenes.GetFirstStep());
  if (scene.Props.empty())
  {
    Say("time step " + std::to_string(scenes.GetFirstStep()) +
      " has no points or cells: the picture is empty");
  }
  return scene;
}
}
