// SPDX-License-Identifier: BSD-3-Clause
// Scenes that only ask how much there is of them.
#ifndef WideFoVScaleScenes_h
#define WideFoVScaleScenes_h

#include <vtkActor.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkSmartPointer.h>

#include <functional>
#include <vector>

namespace wfv
{
namespace scale
{
using Actors = std::vector<vtkSmartPointer<vtkActor>>;
using MakeMapper = std::function<vtkSmartPointer<vtkPolyDataMapper>()>;

// So many small balls, an actor each, spread evenly over directions, on spheres round the origin
// of radius 1 to 2.
Actors MakeBalls(int count, const MakeMapper& mapper);

// A sphere round the origin of that many triangles or a few more, radius 1.
vtkSmartPointer<vtkPolyData> MakeSphere(long triangles);

// So many arrows, as triangles, and as many lines, in front of the eye: within 40 degrees of -z.
Actors MakeArrowsAndLines(int count, const MakeMapper& mapper);

vtkSmartPointer<vtkActor> MakeSurface(vtkPolyData* data, const MakeMapper& mapper);
}
}

#endif
