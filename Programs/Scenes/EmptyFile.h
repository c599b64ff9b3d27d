// SPDX-License-Identifier: BSD-3-Clause
// Valid files that hold nothing, of which VTK's readers complain.
#ifndef WideFoVEmptyFile_h
#define WideFoVEmptyFile_h

#include <vtkDataObject.h>
#include <vtkSmartPointer.h>

#include <string>

namespace widefov
{
// Returns data without points if the file is one of VTK's XML files whose pieces announce none, and
// nullptr otherwise. The file is whole. `ending` begins with a dot.
vtkSmartPointer<vtkDataObject> EmptyData(const std::string& path, const std::string& ending);
}

#endif
