// SPDX-License-Identifier: BSD-3-Clause
#include "Drawables/Kinds/DrawableKinds.h"

#include "Compat/CompositeMapper.h"
#include "Compat/Splats.h"

#include "vtkDataArray.h"
#include "vtkOpenGLSphereMapper.h"
#include "vtkOpenGLStickMapper.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cstring>

namespace wfv
{
namespace
{
// The names of these arrays are for the mappers alone.
class SphereAccess : public vtkOpenGLSphereMapper
{
public:
  static const char* Name(vtkOpenGLSphereMapper* m) { return m->*(&SphereAccess::ScaleArray); }
};

class StickAccess : public vtkOpenGLStickMapper
{
public:
  static const char* Name(vtkOpenGLStickMapper* m) { return m->*(&StickAccess::ScaleArray); }
};

// The largest value of a component of a point array, or the one given where there is none.
double Largest(vtkPolyData* data, const char* name, int component, double otherwise)
{
  vtkDataArray* array = data && name ? data->GetPointData()->GetArray(name) : nullptr;
  if (!array || component >= array->GetNumberOfComponents())
  {
    return otherwise;
  }
  double range[2];
  array->GetRange(range, component);
  return std::max(0.0, range[1]);
}

double OverhangOfSpheres(vtkObjectBase* mapper)
{
  auto* const spheres = static_cast<vtkOpenGLSphereMapper*>(mapper);
  return Largest(spheres->GetInput(), SphereAccess::Name(spheres), 0, spheres->GetRadius());
}

double OverhangOfSticks(vtkObjectBase* mapper)
{
  auto* const sticks = static_cast<vtkOpenGLStickMapper*>(mapper);
  const char* const name = StickAccess::Name(sticks);
  return Largest(sticks->GetInput(), name, 1, 0) + 0.5 * Largest(sticks->GetInput(), name, 0, 0);
}

double OverhangOfSplats(vtkObjectBase* mapper)
{
  auto* const splats = static_cast<vtkPointGaussianMapper*>(mapper);
  return splats->GetScaleFactor() * SplatBound(splats) *
    Largest(splats->GetInput(), splats->GetScaleArray(), 0, 1);
}

struct DrawableKind
{
  const char* Name; // of the class
  unsigned Itself;  // traits of this class, which what is derived from it may not have
  unsigned Derived; // traits of this class and of all that is derived from it
  double (*Overhang)(vtkObjectBase*) = nullptr; // scene units; nullptr: within its bounds
};

constexpr unsigned AsItIs = StockMesh | OneMaterial | InBounds;

const DrawableKind Kinds[] = {
  { "vtkOpenGLPolyDataMapper", AsItIs, 0 },
  { "vtkWideFoVPolyDataMapper", AsItIs, OwnMesh },
  { CompositeMapperName, StockComposite | InBounds, NotItsInput },
  { BlockMapperName, DrawsBlocks, 0 },
  { "vtkWideFoVCompositeHelper", DrawsBlocks | ClassifiesBlocks, 0 },
  { "vtkGlyph3DMapper", 0, NotItsInput | MakesCopies },
  { "vtkOpenGLGlyph3DHelper", OneMaterial, Glyphs },
  { "vtkOpenGLSphereMapper", 0, PointsAlone | Spheres, OverhangOfSpheres },
  { "vtkOpenGLStickMapper", 0, PointsAlone | Cylinders, OverhangOfSticks },
  { "vtkPointGaussianMapper", 0, PointsAlone, OverhangOfSplats },
  { "vtkOpenGLPointGaussianMapperHelper", 0, Splats },
  { "vtkGPUVolumeRayCastMapper", 0, GpuRays },
  { "vtkMultiBlockVolumeMapper", 0, GpuRays },
  { "vtkSmartVolumeMapper", 0, GpuRays | MayChoose },
  { "vtkFixedPointVolumeRayCastMapper", 0, OfImage },
  { "vtkLabelPlacementMapper", 0, InFrontOnly },
  { "vtkOpenGLActor", StockActor, 0 },
  { "vtkDistanceRepresentation3D", 0, KeepsFollowers },
  { "vtkAngleRepresentation3D", 0, KeepsFollowers },
};
}

bool HasTrait(vtkObjectBase* drawable, DrawableTrait trait)
{
  const char* const name = drawable ? drawable->GetClassName() : nullptr;
  return name && std::any_of(std::begin(Kinds), std::end(Kinds), [&](const DrawableKind& kind) {
    return ((kind.Itself & trait) && std::strcmp(name, kind.Name) == 0) ||
      ((kind.Derived & trait) && drawable->IsA(kind.Name));
  });
}

double Overhang(vtkObjectBase* mapper)
{
  // most are these, and to ask of what class something is takes long
  if (HasTrait(mapper, StockMesh))
  {
    return 0;
  }
  const auto found = std::find_if(std::begin(Kinds), std::end(Kinds),
    [mapper](const DrawableKind& kind) { return kind.Overhang && mapper->IsA(kind.Name); });
  return found == std::end(Kinds) ? 0 : found->Overhang(mapper);
}
}
