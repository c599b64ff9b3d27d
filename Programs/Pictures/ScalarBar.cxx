// SPDX-License-Identifier: BSD-3-Clause
#include "ScalarBar.h"

#include "Text/Messages.h"

#include <vtkNew.h>
#include <vtkRenderer.h>
#include <vtkTextProperty.h>
#include <vtkWideFoVOverlayPanel.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace widefov
{
namespace
{
constexpr char LabelFormat[] = "%.3g";

// Of a bar of colours; fewer where they are so long that they would run into each other.
constexpr int Labels = 5;
constexpr int FewLabels = 3;
constexpr int MostCharacters = 12; // of all labels

// Of a bar in a direction.
constexpr double PanelAngle = 50; // degrees
constexpr std::array<int, 2> PanelPixels{ { 1024, 256 } };

// Of the scene's size: nearer than what there is to see.
constexpr double InFront = 0.01;

// Of the near clip sphere: surely beyond it.
constexpr double BeyondNear = 1.01;

int NumberOfLabels(vtkScalarsToColors* map)
{
  const double* const range = map->GetRange();
  int characters = 0;
  for (int i = 0; i < Labels; i++)
  {
    const double value = range[0] + (range[1] - range[0]) * i / (Labels - 1);
    characters += std::snprintf(nullptr, 0, LabelFormat, value);
  }
  return characters > MostCharacters ? FewLabels : Labels;
}

// How far a bar is whose depth nobody says, for one eye; scene units.
double UsualDepth(const Scene& scene, const Options& o)
{
  if (o.HasClip)
  {
    return BeyondNear * o.View.Radii[0];
  }
  double b[6];
  const double size = SceneBounds(scene, b) ? std::hypot(b[1] - b[0], b[3] - b[2], b[5] - b[4]) : 0;
  return size > 0 ? InFront * size : 1;
}

vtkSmartPointer<vtkProp> MakePanel(
  vtkScalarBarActor* bar, vtkRenderer* renderer, const Scene& scene, const Options& o)
{
  bar->SetPosition(0.02, 0.05);
  bar->SetWidth(0.96);
  bar->SetHeight(0.9);
  const std::vector<double>& at = o.ScalarBarAt;
  vtkNew<vtkWideFoVOverlayPanel> panel;
  panel->SetDirection(at[0], at[1]);
  panel->SetAngle(PanelAngle);
  panel->SetDepth(at.size() > 2 ? at[2] : UsualDepth(scene, o));
  panel->SetOverlay(bar, PanelPixels[0], PanelPixels[1]);
  panel->Follow(renderer);
  return panel.Get();
}

// Once, of however many steps of a film.
void SayThatThereIsNone(const Options& o)
{
  static bool said = false;
  if (o.Look.ScalarBar && !said)
  {
    said = true;
    Say(std::string("warning: nothing here is coloured by numbers; there is no bar for ") +
      (o.ScalarBarAt.empty() ? "--scalar-bar" : "--scalar-bar-at"));
  }
}
}

void PlaceBar(vtkScalarBarActor* bar, const Options& o)
{
  const PartOfPicture part = o.Part.value_or(PartOfPicture{ o.Size, { { 0, 0 } } });
  const auto share = [&](int i, double length) { return length * o.Size[i] / part.Whole[i]; };
  const auto place = [&](int i, double at) {
    return double(part.Start[i]) / part.Whole[i] + share(i, at);
  };
  bar->SetPosition(place(0, 0.36), place(1, 0.03));
  bar->SetWidth(share(0, 0.28));
  bar->SetHeight(share(1, 0.10));
}

vtkSmartPointer<vtkScalarBarActor> MakeScalarBar(const Scene& scene)
{
  if (!scene.BarMap)
  {
    return nullptr;
  }
  auto bar = vtkSmartPointer<vtkScalarBarActor>::New();
  bar->SetLookupTable(scene.BarMap);
  bar->SetTitle(scene.BarTitle.c_str());
  bar->SetNumberOfLabels(NumberOfLabels(scene.BarMap));
  bar->SetOrientationToHorizontal();
  PlaceBar(bar, Options());
  bar->SetLabelFormat(LabelFormat);
  for (vtkTextProperty* const text : { bar->GetTitleTextProperty(), bar->GetLabelTextProperty() })
  {
    text->ItalicOff();
    text->ShadowOn();
  }
  return bar;
}

vtkSmartPointer<vtkProp> AddScalarBar(vtkRenderer* renderer, const Scene& scene, const Options& o)
{
  if (!o.Web.empty() && o.ScalarBarAt.empty())
  {
    return nullptr; // the page has the bar
  }
  const vtkSmartPointer<vtkScalarBarActor> bar = MakeScalarBar(scene);
  if (!bar)
  {
    if (!scene.Props.empty())
    {
      SayThatThereIsNone(o);
    }
    return nullptr;
  }
  vtkSmartPointer<vtkProp> shown = bar;
  if (o.ScalarBarAt.empty())
  {
    PlaceBar(bar, o);
  }
  else
  {
    shown = MakePanel(bar, renderer, scene, o);
  }
  renderer->AddViewProp(shown);
  return shown;
}
}
