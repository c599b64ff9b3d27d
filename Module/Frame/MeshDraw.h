// SPDX-License-Identifier: BSD-3-Clause
// Draws the polygons or the strips of a mesh, refined for the view.
#ifndef WideFoVMeshDraw_h
#define WideFoVMeshDraw_h

#include "Frame/FrameStatistics.h"
#include "Frame/RefinedDraw.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkActor;
class vtkPolyData;
class vtkWideFoVStage;
VTK_ABI_NAMESPACE_END

namespace wfv
{
struct Affine;

class MeshDraw
{
public:
  // strips: draws the triangle strips of a mapper; else its polygons.
  explicit MeshDraw(bool strips)
    : Mesh(strips)
  {
  }

  // Refines a mesh for this actor and frame where anything has changed. False if the stage draws
  // all triangles as they are.
  bool Prepare(vtkPolyData* data, vtkActor* actor, vtkWideFoVStage* stage);

  // Draws what was prepared.
  void Draw(const DrawnPart& part, vtkOpenGLRenderWindow* window)
  {
    this->Drawn.Draw(part, this->Mesh.GetCorners(), window);
  }

  // As RefinedDraw has them.
  void SetOwnNumbers(vtkShaderProgram* program, vtkOpenGLRenderWindow* window)
  {
    this->Drawn.SetOwnNumbers(program, window);
  }
  void Finish() { this->Drawn.Finish(); }
  void ReleaseGraphicsResources(vtkWindow* window) { this->Drawn.ReleaseGraphicsResources(window); }

private:
  void Refine(vtkPolyData* data);
  template <typename Real>
  void RefinePoints(const Real* points);
  template <typename Place>
  void RefineCluster(const Refiner& refiner, const Affine& toMap, const Place& place, int cluster,
    EndCache& cache, Refinement& found) const;

  Clusters Mesh;
  RefinedDraw Drawn{ 3 };

  // The last refinement, and the data and the view that it was made for.
  vtkActor* Actor = nullptr; // compared
  vtkPolyData* Data = nullptr;
  vtkMTimeType Time = 0;
  double ToMap[16] = { 0 };
  RefineView View;
  bool Known = false;
  FrameStatistics Counts;
};
}

#endif
