// SPDX-License-Identifier: BSD-3-Clause
#include "Frame/ShaderFolder.h"

#include "Compat/Gl.h"

#include "vtkAbstractMapper.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"

#include <cstdio>
#include <fstream>
#include <utility>
#include <vector>

namespace wfv
{
namespace
{
const char* KindOf(ShaderBuilder::Primitive kind)
{
  using Primitive = ShaderBuilder::Primitive;
  switch (kind)
  {
    case Primitive::Points:
      return "points";
    case Primitive::Lines:
      return "lines";
    case Primitive::Triangles:
      return "triangles";
    case Primitive::Spheres:
      return "spheres";
    case Primitive::Cylinders:
      return "cylinders";
    case Primitive::Splats:
      return "splats";
    case Primitive::PointSpheres:
      return "point-spheres";
    case Primitive::Tubes:
      return "tubes";
  }
  return "";
}

const char* VariantOf(ShaderBuilder::Variant stage)
{
  using Variant = ShaderBuilder::Variant;
  switch (stage)
  {
    case Variant::Projected:
      return "projected";
    case Variant::PreClip:
      return "preclip";
    case Variant::Exact:
      return "exact";
    case Variant::Sky:
      return "sky";
  }
  return "";
}

// Its place among the renderer's props; what is part of another prop has none.
std::string PlaceOf(vtkRenderer* renderer, vtkProp* prop)
{
  vtkPropCollection* const props = renderer->GetViewProps();
  int place = 0;
  vtkCollectionSimpleIterator i;
  props->InitTraversal(i);
  for (vtkProp* other = props->GetNextProp(i); other; other = props->GetNextProp(i))
  {
    if (other == prop)
    {
      return "prop" + std::to_string(place);
    }
    place++;
  }
  return "part";
}

const char* EndingOf(GLint type)
{
  switch (type)
  {
    case GL_VERTEX_SHADER:
      return ".vert";
    case GL_TESS_CONTROL_SHADER:
      return ".tesc";
    case GL_TESS_EVALUATION_SHADER:
      return ".tese";
    case GL_GEOMETRY_SHADER:
      return ".geom";
    default:
      return ".frag";
  }
}

std::string TextOf(GLuint shader)
{
  GLint length = 0; // with the zero at the end
  glGetShaderiv(shader, GL_SHADER_SOURCE_LENGTH, &length);
  std::vector<char> text(static_cast<std::size_t>(length) + 1, '\0');
  glGetShaderSource(shader, length, nullptr, text.data());
  return text.data();
}

// The stages of a program: ending and text.
std::vector<std::pair<std::string, std::string>> StagesOf(GLuint program)
{
  constexpr GLsizei most = 5;
  GLuint shaders[most];
  GLsizei count = 0;
  glGetAttachedShaders(program, most, &count, shaders);
  std::vector<std::pair<std::string, std::string>> stages;
  for (GLsizei i = 0; i < count; i++)
  {
    GLint type = 0;
    glGetShaderiv(shaders[i], GL_SHADER_TYPE, &type);
    stages.emplace_back(EndingOf(type), TextOf(shaders[i]));
  }
  return stages;
}

// Whole or not at all.
bool WriteFile(const std::string& path, const std::string& text)
{
  std::ofstream file(path, std::ios::binary | std::ios::trunc);
  const bool made = file.is_open();
  file << text;
  file.close();
  if (made && !file.good())
  {
    std::remove(path.c_str());
  }
  return file.good();
}
}

void ShaderFolder::SetPath(const std::string& path)
{
  if (path != this->Path)
  {
    *this = ShaderFolder();
    this->Path = path;
  }
}

void ShaderFolder::Forget()
{
  const std::string path = this->Path;
  *this = ShaderFolder();
  this->Path = path;
}

std::string ShaderFolder::NameOf(const ShaderBuilder::Request& request)
{
  return std::string(KindOf(request.Kind)) + "-" + VariantOf(request.Stage);
}

void ShaderFolder::Note(vtkShaderProgram* program, const std::string& what, vtkRenderer* renderer,
  vtkAbstractMapper* mapper, vtkProp* prop)
{
  const auto handle = static_cast<unsigned int>(program->GetHandle());
  const std::string place = PlaceOf(renderer, prop);
  std::string& name = this->Known[handle];
  if (name.empty())
  {
    const std::string first = place + "-" + what;
    name = first;
    for (int i = 2; !this->Names.insert(name).second; i++)
    {
      name = first + "-" + std::to_string(i);
    }
    this->Waiting[handle] = name;
  }
  if (this->Lines.insert(place + " " + mapper->GetClassName() + " " + name + "\n").second)
  {
    this->Listed = false;
  }
}

std::string ShaderFolder::Write()
{
  if (this->Listed)
  {
    return "";
  }
  std::string list;
  for (const std::string& line : this->Lines)
  {
    list += line;
  }
  std::vector<std::pair<std::string, std::string>> files{ { "programs.txt", list } };
  for (const auto& [program, name] : this->Waiting)
  {
    for (const auto& [ending, text] : StagesOf(program))
    {
      files.emplace_back(name + ending, text);
    }
  }
  this->Waiting.clear();
  this->Listed = true;
  for (const auto& [name, text] : files)
  {
    const std::string path = this->Path + "/" + name;
    if (!WriteFile(path, text))
    {
      this->Failed = true;
      return path + " cannot be written; the folder must be there, and open, and have room";
    }
  }
  return "";
}
}
