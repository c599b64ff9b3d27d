// SPDX-License-Identifier: BSD-3-Clause
// Which VTK draws, and whether the module knows it.
#ifndef WideFoVVersionCheck_h
#define WideFoVVersionCheck_h

#include "Projections/Projection.h" // For WFV_EXPORT

#include <string>

namespace wfv
{
// What is to be said of the VTK that runs: that the module was compiled against another release
// (9.3 is one, and 9.6; two VTKs are loaded then), or that it is newer than the newest that was
// tested. Empty where neither is the case. Versions as "9.6.2".
WFV_EXPORT std::string RemarkOnVtk(
  const std::string& running, const std::string& compiled, const std::string& newest);

// Warns of a remark that is not empty.
WFV_EXPORT void WarnWith(const std::string& remark);

// Says it of this VTK, once.
void WarnOfVtk();
}

#endif
