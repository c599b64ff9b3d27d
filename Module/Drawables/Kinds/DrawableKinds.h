// SPDX-License-Identifier: BSD-3-Clause
// The registry of drawables: what is known of VTK's mappers, and of actors, by their classes. A new
// kind is one entry here. What a trait means is done where it is asked for; no other file of the
// module lists classes.
#ifndef WideFoVDrawableKinds_h
#define WideFoVDrawableKinds_h

#include "vtkWideFoVAbi.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkActor;
class vtkObjectBase;
VTK_ABI_NAMESPACE_END

namespace wfv
{
enum DrawableTrait : unsigned
{
  // Mappers of surfaces, lines and points.
  StockMesh = 1u << 0,        // draws its polydata once, as they are
  OwnMesh = 1u << 1,          // vtkWideFoVPolyDataMapper: draws patches, classifies its clusters
  OneMaterial = 1u << 2,      // the actor's property holds for all that it draws
  DrawsBlocks = 1u << 3,      // of composite data; each may have colours and an opacity of its own
  ClassifiesBlocks = 1u << 4, // their clusters (Frame/BlockClusters.h)
  StockComposite = 1u << 5,   // of composite data: hands blocks to what draws them
  InBounds = 1u << 6,         // its bounds hold what it draws, but for widths of lines and points
  NotItsInput = 1u << 7,      // draws its input many times, or blocks of it
  Glyphs = 1u << 8,           // places each copy by a matrix
  PointsAlone = 1u << 9,      // draws its points, whatever the cells are
  Spheres = 1u << 10,         // VTK's geometry stage makes them of points
  Cylinders = 1u << 11,       // the same
  Splats = 1u << 12,          // the same, where it has radii

  // Mappers of volumes.
  GpuRays = 1u << 13,   // draws by GPU ray casting,
  MayChoose = 1u << 14, // unless it is told otherwise (Compat/SmartMapper.h)

  // Others.
  PointLabels = 1u << 15, // labels of places in the picture, which are turned there
  StockActor = 1u << 16,  // draws by its own keys, and once

  // Of a mapper of volumes: what it draws on the processor, GPU ray casting shows alike.
  OfImage = 1u << 17,

  CopiesAtPoints = 1u << 18, // a mapper: draws something else at each point of its input

  // Props that draw beyond GetBounds.
  PartsKnowBounds = 1u << 19, // its actors have the bounds, once it is asked for translucent ones
  BesideBounds = 1u << 20, // some of it is beside its bounds, by no more than half their diagonal

  // Filters that need a linear projection from the camera.
  SortsByCamera = 1u << 21, // along the direction of view
  CullsByCamera = 1u << 22, // by the planes of a frustum

  // Overlays that show the length of things in the picture.
  MeasuresPicture = 1u << 23
};

bool HasTrait(vtkObjectBase* drawable, DrawableTrait trait);

// An actor of VTK's own class with the stock mapper of polydata or ours; followers and levels of
// detail draw another actor.
bool IsStockActor(vtkActor* actor);

// How far the mapper draws beyond the bounds of its points, scene units.
double Overhang(vtkObjectBase* mapper);
}

#endif
