// SPDX-License-Identifier: BSD-3-Clause
// Data that change with time: playing, stopping, and going through their steps.
#include "Loader.h"
#include "Text/Messages.h"
#include "Viewer.h"

#include <cstdio>

namespace widefov
{
// What is due, or asked for; the pose and all else stay.
void Viewer::PlayTime()
{
  const std::optional<std::size_t> wanted = std::exchange(this->WantedStep, std::nullopt);
  if (!this->Time || this->Frames == 0)
  {
    return;
  }
  if (wanted)
  {
    this->ShowStep(*wanted);
  }
  else if (this->Time->GetPause(TimeLine::Clock::now()) == 0.)
  {
    this->ShowStep(this->Time->After(1));
  }
}

void Viewer::ShowStep(std::size_t step)
{
  try
  {
    const auto now = TimeLine::Clock::now();
    const TimeStep& next = this->Time->GetSeries().GetSteps()[step];
    if (!this->Time->IsKept(step) && AreLarge(next.Files))
    {
      // what is read is kept, or else the step of the scenes that were shown last
      this->ReadBeside(next.Files.front(), [this, step] { this->Time->Read(step); });
      this->Windows.SetTitle(NameOf(this->Given.Picture));
    }
    this->What = this->Time->Read(step);
    this->Windows.SetScene(this->What, this->Given.Picture.Look);
    this->Time->Show(step, now);
    this->Unsettled = LayoutsToSettle; // of the slider
    this->Given.Picture.Time = this->Now.Time = next.Time;
    this->Changed();
  }
  catch (const Failure& failure)
  {
    this->Time->Play(false, TimeLine::Clock::now());
    widefov::SayError(failure.what()); // no reason to lose the view
    this->Say(failure.what());
  }
}

// A step back or ahead. False where the action is another.
bool Viewer::StepTime(Action action)
{
  if (action != Action::NextStep && action != Action::PreviousStep)
  {
    return false;
  }
  if (!this->Time)
  {
    this->Say("these data do not change with time");
    return true;
  }
  this->Time->Play(false, TimeLine::Clock::now());
  this->WantedStep = this->Time->After(action == Action::NextStep ? 1 : -1);
  this->Changed();
  return true;
}

// Both the data and the head.
void Viewer::TogglePlay()
{
  const bool poses = this->Around.GetNumber().has_value();
  if (!this->Time && !poses)
  {
    this->Say("there is nothing to play: neither time steps nor poses of --pose FILE");
    return;
  }
  const bool plays = poses ? this->Paused : !this->Time->IsPlaying();
  this->Paused = !plays;
  if (this->Time)
  {
    this->Time->Play(plays, TimeLine::Clock::now());
  }
  this->Changed();
}

std::string Viewer::TextOfTime() const
{
  if (!this->Time)
  {
    return "";
  }
  char line[128];
  std::snprintf(line, sizeof(line), "  time %g, step %zu of %zu", this->Time->GetTime(),
    this->Time->GetStep() + 1, this->Time->GetCount());
  return line;
}
}
