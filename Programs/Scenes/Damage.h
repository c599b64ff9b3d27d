// SPDX-License-Identifier: BSD-3-Clause
// Damage that readers let through and that would crash what comes behind them.
#ifndef WideFoVDamage_h
#define WideFoVDamage_h

#include "vtkWideFoVAbi.h"

#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataObject;
VTK_ABI_NAMESPACE_END

namespace widefov
{
// Each returns an empty string, or what is wrong.

// Cells that use points which are not there, in any dataset of `data`.
std::string DamagedCells(vtkDataObject* data);

// What the ending of the file lets one check before its reader sees it: a binary STL
// shorter than its number of triangles, a MOVIE.BYU file with fewer numbers than it
// announces (VTK 9.1 never ends on one), a PLY file with fewer elements than it announces, a
// classic netCDF file shorter than its variables, an XML file of VTK without its end.
std::string DamagedFile(const std::string& path, const std::string& ending);

// The first of a reader's warnings that says that data are missing; readers also warn
// about what does not concern a picture.
std::string WarningOfDamage(const std::vector<std::string>& warnings);
}

#endif
