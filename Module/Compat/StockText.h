// SPDX-License-Identifier: BSD-3-Clause
// What becomes of a shader in which an edit found nothing.
#ifndef WideFoVStockText_h
#define WideFoVStockText_h

#include "vtkAbstractMapper.h"
#include "vtkObject.h"
#include "Compat/StockEdits.h"

namespace wfv
{
namespace stock
{
// Where an edit found nothing in these: says so by an error of `object`, once for each edit in this
// process, with what is done instead, and returns true.
bool ReportMissing(
  vtkObject* object, vtkAbstractMapper* mapper, const std::string& texts, const char* instead);

// Makes them draw nothing.
void LeaveOut(std::string& vertex, std::string& geometry, std::string& fragment);

// Where an edit found nothing in these: says so and makes them draw nothing. VTK's own text would
// put it elsewhere in a wide picture.
void LeaveOutUnedited(vtkObject* object, vtkAbstractMapper* mapper, std::string& vertex,
  std::string& geometry, std::string& fragment);

// Of a fragment stage: whether that was done.
bool DrawsNothing(const std::string& fragment);
}
}

#endif
