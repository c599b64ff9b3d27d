// SPDX-License-Identifier: BSD-3-Clause
// What polar axes are made of. Members that a subclass may name up to VTK 9.4; private since 9.5,
// which lists what is drawn.
#ifndef WideFoVPluginPolarAxesParts_h
#define WideFoVPluginPolarAxesParts_h

#include <string>
#include <vector>

class vtkActor;
class vtkAxisActor;
class vtkAxisFollower;
class vtkPolarAxesActor;
class vtkRenderer;

namespace wfvplugin
{
// Of what is drawn.
struct PolarAxesParts
{
  vtkAxisActor* Polar = nullptr; // where it is drawn
  std::vector<vtkAxisActor*> Radial;
  std::vector<vtkActor*> Arcs; // and their ticks
};

// Brings them up to date.
PolarAxesParts BuildPolarAxes(vtkPolarAxesActor* stock, vtkRenderer* renderer);

// The letters of an axis's number, below GetNumberOfLabelsBuilt.
vtkAxisFollower* GetLetters(vtkAxisActor* axis, int i);

// A text of VTK's: a string since 9.5, and before that letters, or nothing.
inline std::string TextOf(const std::string& text)
{
  return text;
}
inline std::string TextOf(const char* text)
{
  return text ? text : "";
}
}

#endif
