// SPDX-License-Identifier: BSD-3-Clause
// A molecule as VTK users know it: an atom is a ball, a bond a stick in the colours of its
// two atoms.
#ifndef WideFoVMolecule_h
#define WideFoVMolecule_h

#include "Scene.h"

#include <vtkPolyDataMapper.h>

#include <vector>

namespace widefov
{
// The array that gives sticks the colour of their prop: their mapper cannot do without one.
constexpr const char* StickColor = "stick color";

// True for data whose points are atoms with a radius and whose lines are bonds.
bool IsMolecule(const SceneProp& prop);

// The balls, then the sticks, where there are bonds. All point arrays are kept.
std::vector<SceneProp> BallsAndSticks(const SceneProp& molecule);

// The mapper of such a prop: the stock sphere or stick mapper.
vtkSmartPointer<vtkPolyDataMapper> MakeMapper(const SceneProp& prop);
}

#endif
