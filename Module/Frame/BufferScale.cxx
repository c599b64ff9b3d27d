// SPDX-License-Identifier: BSD-3-Clause
#include "Frame/BufferScale.h"

#include "vtkActor.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkOpenGLVertexBufferObject.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <cmath>

namespace
{
// float32 and not farther from the origin than they are from each other.
bool AreGoodAsTheyAre(vtkPolyData* data)
{
  vtkPoints* const points = data ? data->GetPoints() : nullptr;
  if (!points || points->GetNumberOfPoints() == 0 || points->GetDataType() != VTK_FLOAT)
  {
    return false;
  }
  double b[6];
  data->GetBounds(b);
  const double centre = std::hypot(b[0] + b[1], b[2] + b[3], b[4] + b[5]) / 2;
  return centre <= std::hypot(b[1] - b[0], b[3] - b[2], b[5] - b[4]);
}
}

namespace wfv
{
void BufferScale::Prepare(vtkProp* prop)
{
  auto* const actor = vtkActor::SafeDownCast(prop);
  auto* const mapper = actor ? vtkOpenGLPolyDataMapper::SafeDownCast(actor->GetMapper()) : nullptr;
  if (!mapper)
  {
    return;
  }
  const bool good = AreGoodAsTheyAre(mapper->GetInput());
  const auto known = this->Changed.find(mapper);
  const bool changed = known != this->Changed.end() && known->second == mapper;
  if (good && mapper->GetVBOShiftScaleMethod() == vtkOpenGLVertexBufferObject::AUTO_SHIFT_SCALE)
  {
    mapper->SetVBOShiftScaleMethod(vtkOpenGLVertexBufferObject::DISABLE_SHIFT_SCALE);
    this->Changed[mapper] = mapper;
  }
  else if (!good && changed)
  {
    mapper->SetVBOShiftScaleMethod(vtkOpenGLVertexBufferObject::AUTO_SHIFT_SCALE);
    this->Changed.erase(known);
  }
}
}
