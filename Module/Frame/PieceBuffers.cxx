// SPDX-License-Identifier: BSD-3-Clause
#include "Frame/PieceBuffers.h"

#include "Compat/Gl.h"
#include "Compat/Reports.h"
#include "Compat/VertexBuffers.h"

#include "vtkSMPTools.h"
#include "vtkShaderProgram.h"

#include <cstddef>
#include <type_traits>
#include <vector>

namespace wfv
{
namespace
{
void WarnOfUnreadBuffers()
{
  if (IsNews("unread buffers"))
  {
    vtkGenericWarningMacro("The driver does not let vertex buffers be read: triangles and lines "
                           "that the wide view splits are left out.");
  }
}
}

namespace
{
// Vertices that a thread mixes at least.
constexpr vtkIdType Grain = 4096;

// The attribute that says on which side of a discontinuity a vertex is (common/beside.glsl).
const char* const AsideName = "wfvAside";

// The attribute that says which vertex of the mapper a vertex stands for (vertex_number.glsl).
const char* const NumberName = "wfvVertex";

template <typename Value>
void Mix(const Value* from, const Corners& corners, const Pieces& pieces, std::size_t first,
  unsigned int components, Value* to)
{
  const auto count = static_cast<vtkIdType>(pieces.Vertices.size());
  vtkSMPTools::For(0, count, Grain, [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType i = begin; i < end; i++)
    {
      const std::array<double, 3>& w = pieces.Vertices[i].Weights;
      const auto n = static_cast<std::size_t>(pieces.Corners);
      const std::size_t corner = n * static_cast<std::size_t>(pieces.Sources[i]);
      const Value* const a = from + components * (first + corners[corner]);
      const Value* const b = from + components * (first + corners[corner + 1]);
      const Value* const c = from + components * (first + corners[corner + n - 1]);
      for (unsigned int k = 0; k < components; k++)
      {
        // the sum of two products is the same for both triangles at an edge, because the third is 0
        const double mixed = w[0] == 1 ? a[k]
          : w[1] == 1                  ? b[k]
          : w[2] == 1                  ? c[k]
          : w[2] == 0                  ? w[0] * a[k] + w[1] * b[k]
          : w[1] == 0                  ? w[0] * a[k] + w[2] * c[k]
          : w[0] == 0                  ? w[1] * b[k] + w[2] * c[k]
                                       : w[0] * a[k] + w[1] * b[k] + w[2] * c[k];
        to[components * i + k] =
          static_cast<Value>(std::is_integral<Value>::value ? mixed + 0.5 : mixed);
      }
    }
  });
}
}

bool PieceBuffers::LoadAttribute(Attribute& attribute, vtkOpenGLVertexBufferObject* source,
  const Pieces& pieces, const Corners& corners, unsigned int firstVertex)
{
  const unsigned int stride = source->GetStride();
  const std::size_t size = static_cast<std::size_t>(source->GetNumberOfTuples()) * stride;
  attribute.Stride = stride;
  attribute.Type = source->GetDataType();
  attribute.Components = static_cast<int>(source->GetNumberOfComponents());
  attribute.Time = source->GetUploadTime().GetMTime();
  std::vector<unsigned char> mixed(pieces.Vertices.size() * stride);
  source->Bind();
  const void* const data =
    glMapBufferRange(GL_ARRAY_BUFFER, 0, static_cast<GLsizeiptr>(size), GL_MAP_READ_BIT);
  if (data && attribute.Type == VTK_UNSIGNED_CHAR)
  {
    Mix(
      static_cast<const unsigned char*>(data), corners, pieces, firstVertex, stride, mixed.data());
  }
  else if (data)
  {
    Mix(static_cast<const float*>(data), corners, pieces, firstVertex,
      static_cast<unsigned int>(stride / sizeof(float)), reinterpret_cast<float*>(mixed.data()));
  }
  glUnmapBuffer(GL_ARRAY_BUFFER);
  source->Release();
  attribute.Buffer->Upload(mixed, vtkOpenGLBufferObject::ArrayBuffer);
  return data != nullptr;
}

void PieceBuffers::LoadAsides(const Pieces& pieces)
{
  std::vector<float> asides(pieces.Vertices.size());
  for (std::size_t i = 0; i < asides.size(); i++)
  {
    asides[i] = pieces.Vertices[i].Aside;
  }
  this->Asides->Upload(asides, vtkOpenGLBufferObject::ArrayBuffer);
  this->Indices->Upload(pieces.Indices, vtkOpenGLBufferObject::ElementArrayBuffer);
  this->Indices->IndexCount = pieces.Indices.size();
}

bool PieceBuffers::AsksForNumbers(vtkShaderProgram* program)
{
  return program->IsAttributeUsed(NumberName);
}

void PieceBuffers::LoadNumbers(
  const Pieces& pieces, const Corners& corners, unsigned int firstVertex)
{
  if (this->Numbered)
  {
    return;
  }
  constexpr unsigned int lower = 1u << 16;
  std::vector<float> halves;
  halves.reserve(2 * pieces.Sources.size());
  for (const unsigned int primitive : pieces.Sources)
  {
    const std::size_t corner = static_cast<std::size_t>(pieces.Corners) * primitive;
    const unsigned int number = firstVertex + corners[corner];
    halves.push_back(static_cast<float>(number % lower));
    halves.push_back(static_cast<float>(number / lower + 1));
  }
  this->Numbers->Upload(halves, vtkOpenGLBufferObject::ArrayBuffer);
  this->Numbered = true;
  this->BoundProgram = 0;
}

bool PieceBuffers::Load(const Pieces& pieces, const Corners& corners,
  vtkOpenGLVertexBufferObjectGroup* source, unsigned int firstVertex)
{
  for (auto& known : this->Attributes)
  {
    known.second.Used = false;
  }
  for (const auto& named : VertexBufferAccess::Of(source))
  {
    Attribute& attribute = this->Attributes[named.first];
    attribute.Used = true;
    if (!this->Loaded || attribute.Time != named.second->GetUploadTime().GetMTime())
    {
      this->BoundProgram = 0;
      if (!this->LoadAttribute(attribute, named.second, pieces, corners, firstVertex))
      {
        this->Forget();
        WarnOfUnreadBuffers();
        return false;
      }
    }
  }
  if (!this->Loaded)
  {
    this->LoadAsides(pieces);
    this->BoundProgram = 0;
  }
  this->Loaded = true;
  return true;
}

void PieceBuffers::AddAttributesTo(vtkShaderProgram* program)
{
  for (auto& named : this->Attributes)
  {
    Attribute& a = named.second;
    if (a.Used && program->IsAttributeUsed(named.first.c_str()))
    {
      this->Array->AddAttributeArray(program, a.Buffer, named.first, 0, a.Stride, a.Type,
        a.Components, a.Type == VTK_UNSIGNED_CHAR);
    }
  }
  if (program->IsAttributeUsed(AsideName))
  {
    this->Array->AddAttributeArray(
      program, this->Asides, AsideName, 0, sizeof(float), VTK_FLOAT, 1, false);
  }
  if (this->Numbered && program->IsAttributeUsed(NumberName))
  {
    this->Array->AddAttributeArray(
      program, this->Numbers, NumberName, 0, 2 * sizeof(float), VTK_FLOAT, 2, false);
  }
}

void PieceBuffers::Draw(
  vtkShaderProgram* program, unsigned int mode, const AddAttributes& addOthers)
{
  const auto handle = static_cast<unsigned int>(program->GetHandle());
  const bool known = this->BoundProgram == handle;
  if (!known)
  {
    this->BoundProgram = handle;
    this->Array->ShaderProgramChanged(); // which unbinds the array
  }
  this->Array->Bind();
  if (!known)
  {
    this->AddAttributesTo(program);
    if (addOthers)
    {
      addOthers(this->Array, program);
    }
  }
  this->Indices->Bind();
  glDrawElements(mode, static_cast<GLsizei>(this->Indices->IndexCount), GL_UNSIGNED_INT, nullptr);
  this->Indices->Release();
  this->Array->Release();
}

void PieceBuffers::ReleaseGraphicsResources()
{
  for (auto& named : this->Attributes)
  {
    named.second.Buffer->ReleaseGraphicsResources();
  }
  this->Attributes.clear();
  this->Asides->ReleaseGraphicsResources();
  this->Numbers->ReleaseGraphicsResources();
  this->Indices->ReleaseGraphicsResources();
  this->Array->ReleaseGraphicsResources();
  this->BoundProgram = 0;
  this->Loaded = this->Numbered = false;
}
}
