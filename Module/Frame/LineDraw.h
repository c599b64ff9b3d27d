// SPDX-License-Identifier: BSD-3-Clause
// Draws the segments of a mapper, refined for the view: lines, and the edges of wireframes.
#ifndef WideFoVLineDraw_h
#define WideFoVLineDraw_h

#include "Frame/RefinedDraw.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkActor;
class vtkWideFoVStage;
VTK_ABI_NAMESPACE_END

namespace wfv
{
class LineDraw
{
public:
  // Refines the segments of a part for this actor and frame where anything has changed. time: when
  // the mapper's buffers were built. False if the stage draws all segments as they are.
  bool Prepare(const DrawnPart& part, vtkMTimeType time, vtkActor* actor, vtkWideFoVStage* stage);

  // Draws what was prepared.
  void Draw(const DrawnPart& part, vtkOpenGLRenderWindow* window)
  {
    this->Drawn.Draw(part, this->Ends, window);
  }

  // As RefinedDraw has them.
  void Finish() { this->Drawn.Finish(); }
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  // Reads the segments back from the mapper's buffers: for wireframes they are nowhere else.
  void Read(const DrawnPart& part);
  void Refine();

  RefinedDraw Drawn{ 2 };
  std::vector<unsigned int> Copy; // of the mapper's indices, counted from the first vertex
  Corners Ends;                   // the same
  std::vector<double> Places;     // three coordinates a vertex

  // The last refinement, and the data and the view that it was made for.
  vtkMTimeType Time = 0;
  std::size_t FirstIndex = 0;
  std::size_t Indices = 0;
  double ToMap[16] = { 0 };
  RefineView View;
  bool Known = false;
};
}

#endif
