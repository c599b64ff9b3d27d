// SPDX-License-Identifier: BSD-3-Clause
#include "Drawables/LineMapper.h"

#include "vtkActor.h"
#include "vtkOpenGLHelper.h"
#include "vtkOpenGLIndexBufferObject.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkProperty.h"

#include <algorithm>

namespace
{
// The geometry stage takes each line of a prop once if the prop has more lines.
constexpr int MostFewLines = 500;

// What another class may know of a mapper only from inside.
class LineAccess : public vtkOpenGLPolyDataMapper
{
public:
  static bool DrawsSelection(vtkOpenGLPolyDataMapper* mapper)
  {
    return mapper->*(&LineAccess::DrawingSelection);
  }

  // Of the points that are drawn to pick points, or 0.
  static int PickingSize(vtkOpenGLPolyDataMapper* mapper)
  {
    const vtkOpenGLHelper* buffer = Buffer(mapper);
    const int type = buffer ? buffer->PrimitiveType : static_cast<int>(PrimitivePoints);
    return mapper->*(&LineAccess::PointPicking)
      ? (mapper->*(&LineAccess::GetPointPickingPrimitiveSize))(type)
      : 0;
  }

  static const vtkOpenGLHelper* Buffer(vtkOpenGLPolyDataMapper* mapper)
  {
    return mapper->*(&LineAccess::LastBoundBO);
  }
};
}

namespace wfv
{
float LineWidth(vtkOpenGLPolyDataMapper* mapper, vtkActor* actor)
{
  vtkProperty* property = actor->GetProperty();
  const bool selection = LineAccess::DrawsSelection(mapper);
  return std::max(1.0f, selection ? property->GetSelectionLineWidth() : property->GetLineWidth());
}

float PointSize(vtkOpenGLPolyDataMapper* mapper, vtkActor* actor)
{
  const int picking = LineAccess::PickingSize(mapper);
  vtkProperty* property = actor->GetProperty();
  const bool selection = LineAccess::DrawsSelection(mapper);
  const float size = selection ? property->GetSelectionPointSize() : property->GetPointSize();
  return picking > 0 ? static_cast<float>(picking) : std::max(1.0f, size);
}

bool DrawsSelection(vtkOpenGLPolyDataMapper* mapper)
{
  return LineAccess::DrawsSelection(mapper);
}

bool HasFewLines(vtkOpenGLPolyDataMapper* mapper)
{
  const vtkOpenGLHelper* buffer = LineAccess::Buffer(mapper);
  return buffer && buffer->IBO && buffer->IBO->IndexCount <= 2 * MostFewLines;
}
}
