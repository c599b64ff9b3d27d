// SPDX-License-Identifier: BSD-3-Clause
#include "PolarAxes.h"

#include "FrameThreads.h"
#include "PolarAxesParts.h"

#include "vtkActor.h"
#include "vtkAxisActor.h"
#include "vtkAxisFollower.h"
#include "vtkCoordinate.h"
#include "vtkMapper.h"
#include "vtkPolarAxesActor.h"
#include "vtkRenderer.h"
#include "vtkTextProperty.h"
#include "vtkVectorText.h"

#include <algorithm>
#include <cmath>

namespace wfvplugin
{
namespace
{
// Of an axis, for the direction that it leads in.
constexpr double AlongStep = 1e-3;

// Pixels between the places of numbers: those of nearer ones would cover each other.
constexpr double LeastApart = 30;

// The text of a number, which is known to its letters alone.
std::string NumberOf(vtkAxisActor* axis, int i)
{
  vtkMapper* const letters = GetLetters(axis, i)->GetMapper();
  auto* const text =
    letters ? vtkVectorText::SafeDownCast(letters->GetInputAlgorithm(0, 0)) : nullptr;
  return text ? TextOf(text->GetText()) : "";
}

// A share of the way along an axis.
Point3 PlaceOn(vtkAxisActor* axis, double share)
{
  const double* const from = axis->GetPoint1Coordinate()->GetValue();
  Point3 place;
  std::copy_n(from, 3, place.begin());
  const double* const to = axis->GetPoint2Coordinate()->GetValue();
  for (int i = 0; i < 3; i++)
  {
    place[i] += share * (to[i] - place[i]);
  }
  return place;
}

// Where the axis leads in the picture, there; 0, 0 where the picture does not say.
void FindDirection(vtkRenderer* renderer, vtkAxisActor* axis, double share, double direction[2])
{
  const bool seen =
    FindWay(renderer, PlaceOn(axis, share - AlongStep), PlaceOn(axis, share), direction);
  const double length = seen ? std::hypot(direction[0], direction[1]) : 0;
  for (int i = 0; i < 2; i++)
  {
    direction[i] = length > 0 ? direction[i] / length : 0;
  }
}
}

PolarAxes::PolarAxes(vtkPolarAxesActor* stock)
  : Stock(stock)
{
}

PolarAxes::~PolarAxes()
{
  for (const auto& line : this->Lines)
  {
    this->Renderer->RemoveViewProp(line);
  }
  for (const Axis& axis : this->Axes)
  {
    this->Renderer->RemoveViewProp(axis.Actor);
  }
}

vtkProp* PolarAxes::GetStock() const
{
  return this->Stock;
}

void PolarAxes::Show(vtkRenderer* renderer)
{
  this->Renderer = renderer;
  this->Labels.clear();
  const PolarAxesParts parts = BuildPolarAxes(this->Stock, renderer);
  std::vector<vtkAxisActor*> drawn = parts.Radial;
  vtkAxisActor* const polar = parts.Polar;
  if (polar)
  {
    drawn.push_back(polar);
  }
  this->KeepAxes(drawn);
  for (vtkAxisActor* const axis : drawn)
  {
    this->AddTexts(axis, axis == polar,
      axis == polar ? this->Stock->GetPolarAxisTitleLocation()
                    : this->Stock->GetRadialAxisTitleLocation());
  }
  for (Axis& axis : this->Axes)
  {
    axis.Actor->VisibilityOn();
    axis.Texts = { { axis.Actor->GetTitleVisibility(), axis.Actor->GetLabelVisibility(),
      axis.Actor->GetExponentVisibility() } };
    axis.Actor->SetTitleVisibility(0);
    axis.Actor->SetLabelVisibility(0);
    axis.Actor->SetExponentVisibility(false);
  }
  this->ShowArcs(parts.Arcs);
  // ranks are composited by depth, which translucent texts do not write
  this->Texts.Show(renderer, this->Labels, !HasOneRank());
  this->Stock->VisibilityOff();
}

void PolarAxes::Hide()
{
  for (const auto& line : this->Lines)
  {
    line->VisibilityOff();
  }
  for (const Axis& axis : this->Axes)
  {
    axis.Actor->VisibilityOff(); // the stock actor does not ask for it
    axis.Actor->SetTitleVisibility(axis.Texts[0]);
    axis.Actor->SetLabelVisibility(axis.Texts[1]);
    axis.Actor->SetExponentVisibility(axis.Texts[2] != 0);
  }
  this->Texts.Hide();
  this->Stock->VisibilityOn();
}

void PolarAxes::KeepAxes(const std::vector<vtkAxisActor*>& wanted)
{
  const auto unwanted = [&](const Axis& axis) {
    const bool gone = std::find(wanted.begin(), wanted.end(), axis.Actor) == wanted.end();
    if (gone)
    {
      this->Renderer->RemoveViewProp(axis.Actor);
    }
    return gone;
  };
  this->Axes.erase(
    std::remove_if(this->Axes.begin(), this->Axes.end(), unwanted), this->Axes.end());
  for (vtkAxisActor* const actor : wanted)
  {
    const auto same = [&](const Axis& axis) { return axis.Actor == actor; };
    if (std::none_of(this->Axes.begin(), this->Axes.end(), same))
    {
      actor->UseBoundsOff();
      actor->PickableOff();
      this->Renderer->AddViewProp(actor);
      this->Axes.push_back({ actor, {} });
    }
  }
}

PlacedLabel PolarAxes::MakeLabel(
  vtkAxisActor* axis, double share, const std::string& text, double distance, bool atEnd)
{
  PlacedLabel label{ PlaceOn(axis, share), text, {}, distance, nullptr };
  double along[2];
  FindDirection(this->Renderer, axis, share, along);
  label.Outwards[0] = atEnd ? along[0] : along[1];
  label.Outwards[1] = atEnd ? along[1] : -along[0];
  return label;
}

void PolarAxes::AddTexts(vtkAxisActor* axis, bool polar, int titleLocation)
{
  if (polar && axis->GetLabelVisibility())
  {
    this->AddNumbers(axis);
  }
  const auto add = [&](const std::string& text, bool atEnd) {
    this->Labels.push_back(
      this->MakeLabel(axis, atEnd ? 1 : 0.5, text, polar ? TitleDistance : NumberDistance, atEnd));
    this->Labels.back().Property = axis->GetTitleTextProperty();
  };
  if (axis->GetTitleVisibility())
  {
    add(TextOf(axis->GetTitle()), titleLocation == vtkPolarAxesActor::VTK_TITLE_EXTERN);
  }
  if (polar && axis->GetExponentVisibility())
  {
    add(TextOf(axis->GetExponent()), true);
  }
}

void PolarAxes::AddNumbers(vtkAxisActor* axis)
{
  const double* const range = axis->GetRange();
  const int count = axis->GetNumberOfLabelsBuilt();
  double last[2] = { -2 * LeastApart, 0 }; // outside the picture
  for (int i = 0; i < count; i++)
  {
    const double value =
      i == count - 1 ? range[1] : std::min(range[0] + i * axis->GetDeltaRangeMajor(), range[1]);
    const double share = (value - range[0]) / (range[1] - range[0]);
    PlacedLabel label = this->MakeLabel(axis, share, NumberOf(axis, i), NumberDistance, false);
    label.Property = axis->GetLabelTextProperty();
    if (axis->GetLog())
    {
      std::copy_n(GetLetters(axis, i)->GetPosition(), 3, label.Place.begin());
    }
    double pixel[2];
    if (FindPixel(this->Renderer, label.Place, pixel) &&
      std::hypot(pixel[0] - last[0], pixel[1] - last[1]) >= LeastApart)
    {
      this->Labels.push_back(label);
      std::copy_n(pixel, 2, last);
    }
  }
}

void PolarAxes::ShowArcs(const std::vector<vtkActor*>& arcs)
{
  while (this->Lines.size() < arcs.size())
  {
    auto line = vtkSmartPointer<vtkActor>::New();
    line->UseBoundsOff();
    line->PickableOff();
    this->Renderer->AddViewProp(line);
    this->Lines.push_back(line);
  }
  for (std::size_t i = 0; i < this->Lines.size(); i++)
  {
    vtkActor* const line = this->Lines[i];
    line->SetVisibility(i < arcs.size());
    if (i < arcs.size())
    {
      line->SetMapper(arcs[i]->GetMapper());
      line->SetProperty(arcs[i]->GetProperty());
      line->SetForceOpaque(this->Stock->GetForceOpaque());
    }
  }
}
}
