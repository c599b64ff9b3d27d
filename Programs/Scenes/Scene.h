// SPDX-License-Identifier: BSD-3-Clause
// What is drawn, before there is a window: surfaces, and how they look.
#ifndef WideFoVScene_h
#define WideFoVScene_h

#include "Look.h"

#include <vtkActor.h>
#include <vtkDataObject.h>
#include <vtkImageData.h>
#include <vtkPolyData.h>
#include <vtkScalarsToColors.h>
#include <vtkSmartPointer.h>

#include <optional>
#include <string>
#include <vector>

namespace widefov
{
// One actor.
struct SceneProp
{
  enum class Shape
  {
    Mesh,
    Balls, // one a point, by Molecule.h
    Sticks,
    Volume, // of Source, by Volume.h; of what is drawn none is left
    Outline // of a volume
  };

  vtkSmartPointer<vtkPolyData> Surface;  // what the mapper draws
  vtkSmartPointer<vtkDataObject> Source; // what was read; vectors are looked up here
  int Index = 0;                         // of the file, in the order given; 0 for a built-in scene
  std::string Label;                     // for messages
  Shape Kind = Shape::Mesh;
  double Margin = 0;    // how far what is drawn reaches beyond the points, scene units
  bool InSpace = false; // of 3-D data, and all through them
  bool Globe = false;   // of longitudes and latitudes
  bool Backdrop =
    false;            // a surface under arrows or stream lines: grey unless colours are asked for
  bool Inner = false; // its inner sides are drawn alone

  Vector3 Color{ { 0.9, 0.9, 0.9 } };
  std::string Array; // gives the colours; empty: Color
  bool CellArray = false;
  int Component = -1;  // -1: the magnitude
  bool Direct = false; // the array holds colours already
  vtkSmartPointer<vtkScalarsToColors> ColorMap;
  vtkSmartPointer<vtkActor> Material; // one of the file's; none: Color, Ambient and Diffuse
  double Ambient = 0.25;              // shares of the light, 0 to 1
  double Diffuse = 0.75;
};

// Data that fill space, drawn as such; an outline of them is among the props.
struct SceneVolume
{
  vtkSmartPointer<vtkImageData> Data; // its point scalars, of one component
  vtkSmartPointer<vtkScalarsToColors> ColorMap;
  std::array<double, 2> Range; // of the scalars: clear at the first, dense at the second
};

struct Scene
{
  std::vector<SceneProp> Props;
  std::vector<SceneVolume> Volumes;
  bool FromFiles = false;
  std::optional<Vector3> Eye; // none: the centre of the bounds
  std::string BarTitle;       // of the scalar bar, where BarMap is set
  vtkSmartPointer<vtkScalarsToColors> BarMap;
  std::string Lacks;     // array that was asked for and that this time step has not; empty: none
  std::string Complaint; // message about Lacks
};

// Bounds of all surfaces: xmin, xmax, .., zmax. False where there is nothing.
bool SceneBounds(const Scene& scene, double bounds[6]);

// The scene's eye, or the centre of its bounds.
Vector3 SceneEye(const Scene& scene);

struct PrimitiveCount
{
  long long Triangles = 0;
  long long Lines = 0;
  long long Points = 0;
};

// After polygons and strips are cut into triangles, polylines into segments.
PrimitiveCount CountPrimitives(const Scene& scene);
}

#endif
