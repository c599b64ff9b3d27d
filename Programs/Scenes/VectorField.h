// SPDX-License-Identifier: BSD-3-Clause
// Vector fields as arrows and stream tubes.
#ifndef WideFoVVectorField_h
#define WideFoVVectorField_h

#include <vtkDataObject.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <string>

namespace widefov
{
struct ArrowSettings
{
  double Length = 0;    // of an arrow, scene units; 0: from the points' spacing
  double Reference = 0; // the vector that gets an arrow of that length; 0: one that only a
                        // tenth exceeds, so that a few large ones do not shrink the rest
  double Thickness = 1; // times that of VTK's arrow
  int Most = 5000;      // points beyond this many are thinned out evenly
  int Resolution = 8;   // sides of an arrow
};

// One arrow a point of every dataset in `data`, as long as its vector is large. The
// array's values are kept as point data. Points or vectors that are not finite, and
// vectors of length zero, give no arrow. A cell array is averaged to the points.
vtkSmartPointer<vtkPolyData> MakeArrows(
  vtkDataObject* data, const std::string& array, const ArrowSettings& settings);

struct TubeSettings
{
  double Radius = 0; // scene units; 0: from the size of the data
  double Length = 0; // of a stream line each way, scene units; 0: the diagonal, twice
  int Most = 250;    // seeds, taken evenly from the points where none are given
  int Sides = 8;
  double Step = 0.5;      // largest, in cells
  double AvoidRadius = 0; // no tube nearer to the origin than this
  vtkSmartPointer<vtkPolyData> Seeds;
};

// Stream lines through `data`, both ways from the seeds or forward alone.
vtkSmartPointer<vtkPolyData> MakeStreamLines(
  vtkDataObject* data, const std::string& array, const TubeSettings& settings, bool forward);

// Stream tubes through `data`, a dataset or a composite of datasets.
vtkSmartPointer<vtkPolyData> MakeStreamTubes(
  vtkDataObject* data, const std::string& array, const TubeSettings& settings);
}

#endif
