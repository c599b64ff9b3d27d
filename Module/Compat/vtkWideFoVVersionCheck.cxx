// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWideFoVVersionCheck.h"

#include "vtkObject.h"
#include "vtkVersion.h"

#include <cstdlib>
#include <utility>

namespace
{
// Major and minor number, which order as they should.
std::pair<int, int> Release(const std::string& version)
{
  char* end = nullptr;
  const long major = std::strtol(version.c_str(), &end, 10);
  const long minor = *end == '.' ? std::strtol(end + 1, nullptr, 10) : 0;
  return { static_cast<int>(major), static_cast<int>(minor) };
}

bool Warn()
{
  const std::string remark =
    wfv::RemarkOnVtk(vtkVersion::GetVTKVersion(), VTK_VERSION, WIDEFOV_NEWEST_VTK);
  if (!remark.empty())
  {
    vtkGenericWarningMacro(<< remark);
  }
  return true;
}
}

namespace wfv
{
std::string RemarkOnVtk(
  const std::string& running, const std::string& compiled, const std::string& newest)
{
  if (Release(running) != Release(compiled))
  {
    return "VTK " + running + " draws, but the module was compiled against VTK " + compiled +
      "; two VTKs are loaded, and what comes of it is not defined";
  }
  if (Release(running) > Release(newest))
  {
    return "VTK " + running + " is newer than " + newest +
      ", the newest that this module was tested with; look at the picture before you trust it";
  }
  return "";
}

void WarnOfVtk()
{
  static const bool said = Warn();
  (void)said;
}
}
