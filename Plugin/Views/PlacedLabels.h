// SPDX-License-Identifier: BSD-3-Clause
// Texts beside places of the scene, as a wide view shows them.
#ifndef WideFoVPluginPlacedLabels_h
#define WideFoVPluginPlacedLabels_h

#include "GridBox.h" // For Point3

#include "vtkSmartPointer.h"
#include "vtkType.h" // For vtkMTimeType

#include <string>
#include <vector>

class vtkBillboardTextActor3D;
class vtkRenderer;
class vtkTextProperty;

namespace wfvplugin
{
// Pixels, from a line to its numbers and to its title, as in ParaView.
constexpr double NumberDistance = 10;
constexpr double TitleDistance = 30;

// Pixels of the window, whatever the number of tiles, or false where the picture lacks the place.
bool FindPixel(vtkRenderer* renderer, const Point3& world, double pixel[2]);

// How many pixels right and up of it so short a way is; false where the picture lacks it or tears
// it.
bool FindWay(vtkRenderer* renderer, const Point3& from, const Point3& to, double way[2]);

struct PlacedLabel
{
  Point3 Place; // world
  std::string Text;
  double Outwards[2]; // unit, where the label is from there, in the picture; 0, 0: on its place
  double Distance;    // in that direction, pixels
  vtkTextProperty* Property;
};

class PlacedLabels
{
public:
  ~PlacedLabels();

  // These and no others.
  void Show(vtkRenderer* renderer, const std::vector<PlacedLabel>& labels, bool forceOpaque);
  void Hide();

private:
  struct Text
  {
    vtkSmartPointer<vtkBillboardTextActor3D> Actor;
    vtkTextProperty* From = nullptr; // whose copy it has, as of then
    vtkMTimeType Time = 0;
  };
  static void Update(vtkRenderer* renderer, const PlacedLabel& label, Text& text);

  vtkSmartPointer<vtkRenderer> Renderer; // which the texts are in
  std::vector<Text> Texts;               // as many as there ever were
};
}

#endif
