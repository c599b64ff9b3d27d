// SPDX-License-Identifier: BSD-3-Clause
// Draws the polygons or the strips of a mapper by the classes of their clusters.
#ifndef WideFoVClusterDraw_h
#define WideFoVClusterDraw_h

#include "Clusters/Classifier.h"
#include "Clusters/Clusters.h"
#include "Frame/BufferTexture.h"
#include "Frame/FrameStatistics.h"
#include "vtkWideFoVAbi.h"

#include "vtkNew.h"
#include "vtkOpenGLHelper.h"
#include "vtkOpenGLIndexBufferObject.h"

#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkActor;
class vtkOpenGLRenderWindow;
class vtkPolyData;
class vtkWideFoVStage;
VTK_ABI_NAMESPACE_END

namespace wfv
{
// Where a mesh lies in the buffers of its mapper.
struct DrawnPart
{
  unsigned int FirstVertex = 0;
  unsigned int Vertices = 0;
  std::size_t FirstIndex = 0; // in the mapper's own indices
  std::size_t Indices = 0;
};

class ClusterDraw
{
public:
  // strips: draws the triangle strips of a mapper; else its polygons.
  explicit ClusterDraw(bool strips);

  // Whether there are so many cells that to classify them may pay.
  static bool IsWorthIt(vtkPolyData* data, bool strips);
  static bool IsWorthIt(vtkPolyData* data) // of either
  {
    return IsWorthIt(data, false) || IsWorthIt(data, true);
  }

  // Classifies the clusters of `data` for this actor and frame where anything has changed. False
  // where all triangles are drawn as the stage says, as usual.
  bool Prepare(vtkPolyData* data, vtkActor* actor, vtkWideFoVStage* stage);

  // The triangles that a program draws: those that the stage of the prop draws, those that the
  // vertex stage projects, those that are cut into smaller ones before, and those that are
  // ray-tested as well but end at an edge of several chords, which takes a longer program; All:
  // every triangle, in the mapper's own order.
  enum Kind
  {
    ByStage,
    Projected,
    Cut,
    AtChords,
    NumberOfKinds,
    All = NumberOfKinds
  };
  void Choose(Kind kind) { this->Chosen = kind; }

  // Of what was prepared last.
  bool Has(Kind kind) const { return this->Draws[kind].Triangles > 0; }

  // Draws the chosen ones, with the program that is bound. all: the mapper's own indices.
  void Draw(vtkOpenGLIndexBufferObject* all, const DrawnPart& part);

  // The numbers that the chosen triangles have in the mapper, where the program asks for them.
  void SetParameters(vtkShaderProgram* program, vtkWindow* window);

  // After the mapper has drawn.
  void Finish();

  // What draws a kind of the triangles of a prop that has this stage.
  static vtkWideFoVStage* GetStage(Kind kind, vtkWideFoVStage* stage);

  // The programs of a mapper for what does not have its own.
  vtkOpenGLHelper& GetHelper(Kind kind) { return this->Helpers[kind]; }

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  // Triangles of one kind: draw ranges of complete clusters, by the mapper's own indices, and those
  // of mixed clusters, by indices of their own.
  struct KindDraw
  {
    std::vector<vtkIdType> Firsts;
    std::vector<vtkIdType> Counts;
    std::vector<unsigned int> Singles;
    vtkIdType Triangles = 0;

    // Of what is in the buffer: all of them, for a program that asks for their numbers, or the
    // single ones alone.
    vtkNew<vtkOpenGLIndexBufferObject> Indices;
    std::size_t InBuffer = 0;
    bool Loaded = false;
    bool Numbered = false;
    BufferTexture Numbers;
    BufferTexture Chords;

    void Clear();
    void Take(KindDraw& other);
    void AddRun(vtkIdType first, vtkIdType count);
    std::vector<unsigned int> ListAll() const;
    bool IsWhole(vtkIdType triangles) const { return this->Triangles == triangles; }
  };

  void Classify(vtkPolyData* data);
  template <typename Real>
  void ClassifyPoints(const Real* points);
  void Gather();
  void AddMixed(int cluster);
  std::vector<unsigned int> ListChords(const std::vector<unsigned int>& triangles) const;
  void Load(KindDraw& draw, bool numbered);
  void DrawRuns(const KindDraw& draw, std::size_t firstIndex);
  void LoadLists(KindDraw& draw, vtkOpenGLRenderWindow* window);
  bool IsOwn() const; // the chosen ones are all of the mesh, in the mapper's order

  const bool ForStrips;
  Clusters Mesh;

  // What was classified last, and for what.
  vtkActor* Actor = nullptr; // compared
  vtkPolyData* Data = nullptr;
  vtkMTimeType Time = 0;
  double ToMap[16] = { 0 };
  ClassifierView View;
  bool Known = false;

  std::vector<DrawClass> Classes;  // of the clusters
  std::vector<unsigned int> Codes; // of the triangles of mixed clusters: the kind, and the chords
                                   // of each edge
  KindDraw Draws[NumberOfKinds];
  FrameStatistics Found;
  std::vector<int> RunLengths;        // kept for their memory
  std::vector<const void*> RunStarts; // likewise

  Kind Chosen = All;
  bool Numbered = false; // the program that is bound asks for numbers
  bool Bound = false;    // a texture is, to a unit of its own
  BufferTexture Nothing; // a texture there has to be
  vtkOpenGLHelper Helpers[NumberOfKinds];
};

// Makes the fragment stage of a mapper that draws so ask for those numbers.
void TakeTriangleNumbers(std::string& fragment);
}

#endif
