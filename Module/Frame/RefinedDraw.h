// SPDX-License-Identifier: BSD-3-Clause
// Draws triangles or segments that were refined for a view: those that need nothing from the
// mapper's own buffers, the pieces of the other ones from buffers of their own, with one program.
#ifndef WideFoVRefinedDraw_h
#define WideFoVRefinedDraw_h

#include "Frame/BufferTexture.h"
#include "Frame/PieceBuffers.h"
#include "Refine/Clusters.h"
#include "Refine/Refiner.h"
#include "vtkWideFoVAbi.h"

#include "vtkNew.h"
#include "vtkOpenGLIndexBufferObject.h"

#include <algorithm>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLHelper;
class vtkOpenGLRenderWindow;
class vtkOpenGLVertexBufferObjectGroup;
VTK_ABI_NAMESPACE_END

namespace wfv
{
// Says where primitives lie in the buffers of their mapper.
struct DrawnPart
{
  vtkOpenGLHelper* Helper = nullptr; // whose program is ready
  vtkOpenGLVertexBufferObjectGroup* Buffers = nullptr;
  unsigned int FirstVertex = 0;
  unsigned int Vertices = 0;
  std::size_t FirstIndex = 0; // in the mapper's own indices
  std::size_t Indices = 0;
};

// Lists the primitives that are drawn as they are, and the pieces of the other ones. Each thread
// fills one.
struct Refinement
{
  // Primitives that are drawn as they are: ranges of the mapper's own order, and single ones.
  std::vector<vtkIdType> Firsts;
  std::vector<vtkIdType> Counts;
  std::vector<unsigned int> Singles;
  Pieces Refined;
  vtkIdType Culled = 0; // primitives
  int CulledClusters = 0;

  void AddRun(vtkIdType first, vtkIdType count);
  void Append(const Refinement& other);
  vtkIdType CountFine() const;
  std::vector<unsigned int> ListFine() const;
};

// Gives a program the numbers that primitives have in the mapper, where it asks for them.
class NumberTable
{
public:
  // list: called where the numbers are not loaded yet; returns at least one number.
  template <typename List>
  void Activate(vtkShaderProgram* program, vtkOpenGLRenderWindow* window, List list)
  {
    if (!program->IsUniformUsed("wfvNumbers"))
    {
      return;
    }
    if (!this->Loaded || !this->Texture.IsLoadedFor(window))
    {
      this->Texture.Load(window, list());
      this->Loaded = true;
    }
    this->Texture.Activate(program, "wfvNumbers");
    program->SetUniformi("wfvFirstNumber", 0);
  }

  void Deactivate() { this->Texture.Deactivate(); }
  void Forget() { this->Loaded = false; }

  void ReleaseGraphicsResources(vtkWindow* window)
  {
    this->Texture.ReleaseGraphicsResources(window);
    this->Loaded = false;
  }

private:
  BufferTexture Texture;
  bool Loaded = false;
};

class RefinedDraw
{
public:
  // Parts that threads take one after the other, for so many things to do; least: in a part.
  static std::size_t CountParts(std::size_t things, std::size_t least)
  {
    constexpr std::size_t most = 32;
    return std::clamp<std::size_t>(things / least, 1, most);
  }

  // corners: of a primitive, 3 for triangles, 2 for segments.
  explicit RefinedDraw(int corners)
    : NumberOfCorners(corners)
  {
  }

  // Takes what Draw draws from now on. total: primitives of the mapper.
  void Take(const std::vector<Refinement>& parts, vtkIdType total);
  const Refinement& Get() const { return this->What; }

  // corners: indices of vertices, counted from the first vertex of the part.
  void Draw(const DrawnPart& part, const Corners& corners, vtkOpenGLRenderWindow* window);

  // For a program that draws primitives in the mapper's own order. The texture that it may ask for
  // stays active until Finish.
  void SetOwnNumbers(vtkShaderProgram* program, vtkOpenGLRenderWindow* window);
  void Finish();

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  unsigned int Mode() const;
  void LoadFine(const Corners& corners, bool numbered);
  void DrawRanges(const DrawnPart& part);
  void DrawOwn(const DrawnPart& part, vtkOpenGLRenderWindow* window);
  void DrawFine(const DrawnPart& part, const Corners& corners, vtkOpenGLRenderWindow* window);
  void DrawPieces(const DrawnPart& part, const Corners& corners, vtkOpenGLRenderWindow* window);

  const int NumberOfCorners;
  Refinement What;
  vtkIdType Total = 0;

  vtkNew<vtkOpenGLIndexBufferObject> Indices; // of fine primitives: all, for a program that asks
  std::size_t InBuffer = 0;                   // for their numbers, or the single ones alone
  bool Loaded = false;
  bool Numbered = false;
  NumberTable FineNumbers;
  NumberTable PieceNumbers;
  PieceBuffers Buffers;
  BufferTexture Nothing;              // a texture there has to be
  std::vector<int> RunLengths;        // kept for their memory
  std::vector<const void*> RunStarts; // likewise
};

// Makes the stages of a mapper that draws so ask for the numbers that primitives and vertices have
// in the mapper.
void TakeNumbers(std::string& vertex, std::string& fragment);
}

#endif
