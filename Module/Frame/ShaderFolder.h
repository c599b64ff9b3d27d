// SPDX-License-Identifier: BSD-3-Clause
// The text of the shader programs, as files to read.
#ifndef WideFoVShaderFolder_h
#define WideFoVShaderFolder_h

#include "Shaders/ShaderBuilder.h"
#include "vtkWideFoVAbi.h"

#include <map>
#include <set>
#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkAbstractMapper;
class vtkProp;
class vtkRenderer;
class vtkShaderProgram;
VTK_ABI_NAMESPACE_END

namespace wfv
{
// Writes each program once, as OpenGL has it: a file a stage, named by the first prop that it
// draws, what it draws and how: prop0-triangles-cut.vert. The endings are those that
// glslangValidator knows: vert, tesc, tese, geom, frag. programs.txt has a line for each prop and
// program.
class ShaderFolder
{
public:
  // Empty: none. Another one has every program written anew.
  void SetPath(const std::string& path);

  // Of a context that goes: the numbers of its programs stand for others from now on.
  void Forget();

  bool IsOpen() const { return !this->Path.empty() && !this->Failed; }

  // While it is open: a prop is drawn with this program. Its text may not be finished yet: a
  // tessellation is added after this.
  // what: it draws, and how (NameOf).
  void Note(vtkShaderProgram* program, const std::string& what, vtkRenderer* renderer,
    vtkAbstractMapper* mapper, vtkProp* prop);
  static std::string NameOf(const ShaderBuilder::Request& request);

  // Writes what was noted, after a frame. Empty, or what is wrong: nothing more is written then,
  // until there is another path.
  std::string Write();

private:
  std::string Path;
  std::map<unsigned int, std::string> Waiting; // handle of a program, its name
  std::map<unsigned int, std::string> Known;   // those that are written, too
  std::set<std::string> Names;
  std::set<std::string> Lines; // of programs.txt
  bool Listed = true;          // all of them are in it
  bool Failed = false;
};
}

#endif
