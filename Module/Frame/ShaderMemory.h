// SPDX-License-Identifier: BSD-3-Clause
// Shader texts that were made before.
#ifndef WideFoVShaderMemory_h
#define WideFoVShaderMemory_h

#include "Shaders/ShaderBuilder.h"

#include <string>
#include <unordered_map>

namespace wfv
{
// VTK has the text of every prop's shaders made anew, also where a thousand props are alike. What
// wfv::ShaderBuilder makes of a text takes half a millisecond, and depends on nothing but the
// text and the request.
class ShaderMemory
{
public:
  using Request = wfv::ShaderBuilder::Request;

  struct Texts
  {
    std::string Vertex;
    std::string Geometry;
    std::string Fragment;
  };

  struct Circumstances
  {
    bool Numbered; // they are told to ask for the numbers of triangles (TakeNumbers)
    bool Others;   // edit them further (IsEditedFurther)
  };

  // What became of these texts, or nullptr.
  const Texts* Find(const Request& request, const Circumstances& circumstances, const Texts& texts);

  // Of the texts that were looked for last.
  void Keep(const Texts& made);

private:
  std::string Wanted; // the key
  std::unordered_map<std::string, Texts> Made;
};
}

#endif
