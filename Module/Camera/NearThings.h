// SPDX-License-Identifier: BSD-3-Clause
// Finds the distance from the eye to the nearest prop. Automatic clip spheres need it if the bounds
// of the scene contain the eye, because the bounds say nothing about near props then.
#ifndef WideFoVNearThings_h
#define WideFoVNearThings_h

#include "vtkWideFoVAbi.h"

#include "vtkType.h"

#include <array>
#include <functional>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkProp;
class vtkRenderer;
VTK_ABI_NAMESPACE_END

namespace wfv
{
class NearThings
{
public:
  // Tests whether the view may show a part of a box (xmin, xmax, .., zmax; world).
  using SeenTest = std::function<bool(const double bounds[6])>;

  // Begins to look for what is nearer to the eye (world) than a distance.
  void Begin(const double eye[3], double within);

  // Adds the visible props of a renderer. Their bounds must be up to date.
  void Add(vtkRenderer* renderer);

  // Returns the distance to the nearest of them, or infinity if none is nearer than asked for. Of a
  // mesh with many cells, an even sample of these is measured. Props that have not changed since
  // the last call with the same eye are not measured anew.
  double Find(const SeenTest& isSeen);

private:
  struct Candidate
  {
    vtkProp* Prop; // compared; used in its frame only
    vtkMTimeType Time;
    bool operator==(const Candidate& o) const { return Prop == o.Prop && Time == o.Time; }
  };

  std::array<double, 4> Asked{ { 0, 0, 0, 0 } };      // eye and distance
  std::array<double, 4> LastAsked{ { 0, 0, 0, -1 } }; // that Found is of
  std::vector<Candidate> Candidates;
  std::vector<Candidate> LastCandidates;
  double Found = 0;
};
}

#endif
