// SPDX-License-Identifier: BSD-3-Clause
#include "Drawables/MeshScale.h"

#include "Drawables/Kinds/DrawableKinds.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
constexpr double Unknown = std::numeric_limits<double>::infinity();

// Squared; every point to the one before it, a polygon's last to its first, and in strips
// to the one before that. VTK draws polygons as fans, so theirs counts from the first too.
double LongestSquared(vtkPoints* points, vtkCellArray* cells, bool fan, bool strip)
{
  double longest = 0;
  const auto measure = [&](vtkIdType a, vtkIdType b) {
    double p[3];
    double q[3];
    points->GetPoint(a, p);
    points->GetPoint(b, q);
    longest = std::max(longest, vtkMath::Distance2BetweenPoints(p, q));
  };
  auto it = vtk::TakeSmartPointer(cells->NewIterator());
  for (it->GoToFirstCell(); !it->IsDoneWithTraversal(); it->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    it->GetCurrentCell(size, ids);
    for (vtkIdType i = 1; i < size; i++)
    {
      measure(ids[i - 1], ids[i]);
      if (i > 1 && (fan || strip))
      {
        measure(ids[fan ? 0 : i - 2], ids[i]);
      }
    }
  }
  return longest;
}

// The largest factor by which a matrix lengthens anything, or a little more.
double MostLengthening(vtkMatrix4x4* m)
{
  double sum = 0;
  for (int i = 0; i < 3; i++)
  {
    for (int j = 0; j < 3; j++)
    {
      sum += m->GetElement(i, j) * m->GetElement(i, j);
    }
  }
  // Frobenius' norm is at least the largest singular value; of a rotation it is sqrt 3
  return m->IsIdentity() ? 1 : std::sqrt(sum);
}
}

namespace wfv
{
double LongestEdge(vtkPolyData* data)
{
  vtkPoints* const points = data->GetPoints();
  if (!points)
  {
    return 0;
  }
  const double longest = std::max({ LongestSquared(points, data->GetLines(), false, false),
    LongestSquared(points, data->GetPolys(), true, false),
    LongestSquared(points, data->GetStrips(), false, true) });
  return std::isfinite(longest) ? std::sqrt(longest) : Unknown;
}

double MeshScale::Get(vtkProp* prop)
{
  auto* const actor = vtkActor::SafeDownCast(prop);
  auto* const mapper = actor ? vtkPolyDataMapper::SafeDownCast(actor->GetMapper()) : nullptr;
  if (!mapper || HasTrait(mapper, NotItsInput) || !mapper->GetInput())
  {
    return Unknown;
  }
  vtkPolyData* const data = mapper->GetInput();
  Entry& entry = this->Entries[mapper];
  if (entry.Mapper != mapper || entry.Data != data || entry.Time != data->GetMTime())
  {
    entry = { mapper, data, data->GetMTime(), LongestEdge(data) };
  }
  return entry.Longest * MostLengthening(actor->GetMatrix());
}
}
