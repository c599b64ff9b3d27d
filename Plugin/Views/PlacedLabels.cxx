// SPDX-License-Identifier: BSD-3-Clause
#include "PlacedLabels.h"

#include "vtkBillboardTextActor3D.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTextProperty.h"

#include <cmath>

namespace wfvplugin
{
namespace
{
// How long a short way may be, of the picture: a longer one is torn.
constexpr double LongestPiece = 0.25;

// Sine or cosine below which a direction has no right and left, or above and below.
constexpr double Level = 0.342; // of 20 degrees

}

// Pixels of the window, whatever the number of tiles, or false where the picture lacks the place.
bool FindPixel(vtkRenderer* renderer, const Point3& world, double pixel[2])
{
  double x = world[0];
  double y = world[1];
  double z = world[2];
  renderer->WorldToView(x, y, z);
  const int* const size = renderer->GetRenderWindow()->GetActualSize();
  const double* const viewport = renderer->GetViewport();
  pixel[0] = 0.5 * (x + 1) * size[0] * (viewport[2] - viewport[0]);
  pixel[1] = 0.5 * (y + 1) * size[1] * (viewport[3] - viewport[1]);
  return std::abs(x) <= 1 && std::abs(y) <= 1; // not where they are no numbers
}

// How many pixels right and up of it so short a way is.
bool FindWay(vtkRenderer* renderer, const Point3& from, const Point3& to, double way[2])
{
  double start[2];
  double end[2];
  if (!FindPixel(renderer, from, start) || !FindPixel(renderer, to, end))
  {
    return false;
  }
  const int* const size = renderer->GetRenderWindow()->GetActualSize();
  for (int i = 0; i < 2; i++)
  {
    way[i] = end[i] - start[i];
    if (std::abs(way[i]) > LongestPiece * size[i])
    {
      return false;
    }
  }
  return true;
}

PlacedLabels::~PlacedLabels()
{
  for (const Text& text : this->Texts)
  {
    this->Renderer->RemoveViewProp(text.Actor);
  }
}

void PlacedLabels::Update(vtkRenderer* renderer, const PlacedLabel& label, Text& text)
{
  vtkTextProperty* const own = text.Actor->GetTextProperty();
  if (text.From != label.Property || text.Time < label.Property->GetMTime())
  {
    own->ShallowCopy(label.Property);
    text.From = label.Property;
    text.Time = label.Property->GetMTime();
  }
  const double x = label.Outwards[0];
  const double y = label.Outwards[1];
  own->SetJustification(std::abs(x) < Level ? VTK_TEXT_CENTERED
      : x > 0                               ? VTK_TEXT_LEFT
                                            : VTK_TEXT_RIGHT);
  own->SetVerticalJustification(std::abs(y) < Level ? VTK_TEXT_CENTERED
      : y > 0                                       ? VTK_TEXT_BOTTOM
                                                    : VTK_TEXT_TOP);
  int scale[2];
  renderer->GetRenderWindow()->GetTileScale(scale);
  text.Actor->SetInput(label.Text.c_str());
  text.Actor->SetPosition(label.Place[0], label.Place[1], label.Place[2]);
  text.Actor->SetDisplayOffset(static_cast<int>(std::lround(label.Distance * x * scale[0])),
    static_cast<int>(std::lround(label.Distance * y * scale[1])));
  text.Actor->SetVisibility(!label.Text.empty());
}

void PlacedLabels::Show(
  vtkRenderer* renderer, const std::vector<PlacedLabel>& labels, bool forceOpaque)
{
  this->Renderer = renderer;
  while (this->Texts.size() < labels.size())
  {
    Text text;
    text.Actor = vtkSmartPointer<vtkBillboardTextActor3D>::New();
    text.Actor->UseBoundsOff();
    text.Actor->PickableOff();
    renderer->AddViewProp(text.Actor);
    this->Texts.push_back(text);
  }
  this->Hide();
  for (std::size_t i = 0; i < labels.size(); i++)
  {
    Update(renderer, labels[i], this->Texts[i]);
    this->Texts[i].Actor->SetForceOpaque(forceOpaque);
  }
}

void PlacedLabels::Hide()
{
  for (const Text& text : this->Texts)
  {
    text.Actor->VisibilityOff();
  }
}
}
