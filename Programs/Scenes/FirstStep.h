// SPDX-License-Identifier: BSD-3-Clause
// What is told of data that change with time: their first step.
#ifndef WideFoVFirstStep_h
#define WideFoVFirstStep_h

#include <vtkDataObject.h>
#include <vtkSmartPointer.h>

#include <string>
#include <vector>

namespace widefov
{
struct FirstStep
{
  vtkSmartPointer<vtkDataObject> Data;
  std::vector<double> Times; // of all steps; none where the data do not change
};

// Of a name on the command line: the first step of a series, in one piece, or the file. Throws a
// Failure with ExitFailed where the list or the step cannot be read.
FirstStep ReadFirstStep(const std::string& path);
}

#endif
