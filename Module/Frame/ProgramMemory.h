// SPDX-License-Identifier: BSD-3-Clause
// What the programs of a frame have been told already.
#ifndef WideFoVProgramMemory_h
#define WideFoVProgramMemory_h

#include "Frame/Eye.h"
#include "vtkWideFoVAbi.h"

#include <algorithm>
#include <cstdint>
#include <unordered_map>

VTK_ABI_NAMESPACE_BEGIN
class vtkShaderProgram;
VTK_ABI_NAMESPACE_END

namespace wfv
{
// Of the uniforms of a program that depend on the prop, those that it has.
struct ProgramUses
{
  bool Samples = false;
  EyeUniforms Eye;
  bool LineWidth = false;
  bool FrontCulled = false;
  bool PointSize = false;
  bool Pixels = false;
  bool PolygonOffset = false;
  bool FineDepth = false;
};

// Uniforms stay in a program, so what is the same for a whole frame is set once, however many
// props the program draws; and names are looked up once, too. Others draw with the same programs,
// but not within a frame of one pass.
class ProgramMemory
{
public:
  struct Entry
  {
    std::uint64_t Frame = 0;
    int Viewport[4] = { 0, 0, 0, 0 };
    ProgramUses Uses;
  };

  void BeginFrame() { this->Frame++; }

  // What is known of the program; its uniforms are those of this frame and viewport if IsSet.
  Entry& Get(vtkShaderProgram* program) { return this->Entries[program]; }
  bool IsSet(const Entry& entry, const int viewport[4]) const
  {
    return entry.Frame == this->Frame && std::equal(viewport, viewport + 4, entry.Viewport);
  }
  void NoteSet(Entry& entry, const int viewport[4]) const
  {
    entry.Frame = this->Frame;
    std::copy(viewport, viewport + 4, entry.Viewport);
  }

  // One that is linked anew has lost its uniforms.
  void Forget(vtkShaderProgram* program) { this->Entries.erase(program); }
  void ForgetAll() { this->Entries.clear(); }

private:
  std::uint64_t Frame = 1;
  std::unordered_map<vtkShaderProgram*, Entry> Entries;
};
}

#endif
