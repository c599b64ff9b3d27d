// SPDX-License-Identifier: BSD-3-Clause
#include "Frame/LineDraw.h"

#include "Compat/Gl.h"
#include "Compat/VertexBuffers.h"
#include "Frame/Stages.h"
#include "Frame/vtkWideFoVStage.h"
#include "Refine/Affine.h"

#include "vtkActor.h"
#include "vtkOpenGLHelper.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <chrono>

namespace wfv
{
namespace
{
// Segments that a thread takes at least.
constexpr std::size_t LeastSegments = 1024;

// The values of a buffer from one place on, in OpenGL's own bytes.
template <typename Value>
std::vector<Value> ReadBuffer(
  vtkOpenGLBufferObject* buffer, unsigned int target, std::size_t first, std::size_t count)
{
  std::vector<Value> values(count);
  buffer->Bind();
  glGetBufferSubData(target, static_cast<GLintptr>(first * sizeof(Value)),
    static_cast<GLsizeiptr>(count * sizeof(Value)), values.data());
  buffer->Release();
  return values;
}
}

void LineDraw::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Drawn.ReleaseGraphicsResources(window);
  this->Known = false;
}

void LineDraw::Read(const DrawnPart& part)
{
  this->Copy = ReadBuffer<unsigned int>(
    part.Helper->IBO, GL_ELEMENT_ARRAY_BUFFER, part.FirstIndex, part.Indices);
  for (unsigned int& index : this->Copy)
  {
    index -= part.FirstVertex;
  }
  this->Ends.Take(this->Copy);
  vtkOpenGLVertexBufferObject* const vertices = VertexBufferAccess::Of(part.Buffers).at("vertexMC");
  const std::size_t stride = vertices->GetStride() / sizeof(float);
  const std::vector<float> all =
    ReadBuffer<float>(vertices, GL_ARRAY_BUFFER, stride * part.FirstVertex, stride * part.Vertices);
  const bool moved = vertices->GetCoordShiftAndScaleEnabled();
  this->Places.resize(3 * static_cast<std::size_t>(part.Vertices));
  for (std::size_t i = 0; i < this->Places.size(); i++)
  {
    const double value = all[stride * (i / 3) + i % 3];
    this->Places[i] =
      moved ? value / vertices->GetScale()[i % 3] + vertices->GetShift()[i % 3] : value;
  }
}

bool LineDraw::Prepare(
  const DrawnPart& part, vtkMTimeType time, vtkActor* actor, vtkWideFoVStage* stage)
{
  wfv::Stages* const stages = stage->GetStages();
  RefineView view;
  if (!stages || !stages->GetRefineView(stage, actor, view) || !view.Limits)
  {
    return false;
  }
  double toMap[16];
  stages->GetToMap(actor, toMap);
  const bool read =
    this->Time == time && this->FirstIndex == part.FirstIndex && this->Indices == part.Indices;
  const bool still =
    this->Known && read && std::equal(toMap, toMap + 16, this->ToMap) && this->View == view;
  if (!still)
  {
    this->Known = true;
    this->Time = time;
    this->FirstIndex = part.FirstIndex;
    this->Indices = part.Indices;
    this->View = view;
    std::copy_n(toMap, 16, this->ToMap);
    const auto start = std::chrono::steady_clock::now();
    if (!read)
    {
      this->Read(part);
    }
    this->Refine();
    stages->AddRefineTime(start);
  }
  return true;
}

void LineDraw::Refine()
{
  const Refiner refiner(this->View);
  const Affine toMap(this->ToMap);
  const auto place = [&](std::size_t end) {
    const double* const p = this->Places.data() + 3 * static_cast<std::size_t>(this->Copy[end]);
    return toMap.Of(p[0], p[1], p[2]);
  };
  const std::size_t segments = this->Copy.size() / 2;
  const std::size_t parts = RefinedDraw::CountParts(segments, LeastSegments);
  std::vector<Refinement> found(parts);
  vtkSMPTools::For(0, static_cast<vtkIdType>(parts), 1, [&](vtkIdType from, vtkIdType to) {
    for (auto part = static_cast<std::size_t>(from); part < static_cast<std::size_t>(to); part++)
    {
      for (std::size_t i = part * segments / parts; i < (part + 1) * segments / parts; i++)
      {
        const auto number = static_cast<unsigned int>(i);
        if (refiner.Take(place(2 * i), place(2 * i + 1), number, found[part].Refined))
        {
          found[part].AddRun(static_cast<vtkIdType>(i), 1);
        }
      }
    }
  });
  this->Drawn.Take(found, static_cast<vtkIdType>(segments));
}
}
