// SPDX-License-Identifier: BSD-3-Clause
// What VTK writes into the shaders of a mapper, by what the mapper says of itself: what an edit
// must find is not decided by the text in which it looks. And what becomes of a shader in which
// something was not found.
#ifndef vtkWideFoVStockText_h
#define vtkWideFoVStockText_h

#include "vtkAbstractMapper.h"
#include "vtkObject.h"
#include "vtkProp.h"
#include "vtkWideFoVStockEdits.h"

namespace wfv
{
namespace stock
{
Facts Describe(vtkAbstractMapper* mapper, vtkProp* prop);

// Where an edit found nothing in one of these: says so by an error of `object`, once for each edit
// in this process, and returns true.
bool ReportMissing(vtkObject* object, vtkAbstractMapper* mapper, const std::string& vertex,
  const std::string& geometry, const std::string& fragment);

// Stages that draw nothing at all, whatever the mapper binds and sets.
void DrawNothing(std::string& vertex, std::string& geometry, std::string& fragment);
WFV_EXPORT bool DrawsNothing(const std::string& fragment);

// As if nothing had been said yet: for tests.
WFV_EXPORT void ForgetReports();
}
}

#endif
