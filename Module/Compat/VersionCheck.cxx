// SPDX-License-Identifier: BSD-3-Clause
#include "Compat/VersionCheck.h"

#include "vtkObject.h"
#include "vtkVersion.h"

#include <cstdlib>
#include <mutex>
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
}

namespace wfv
{
std::string RemarkOnVtk(
  const std::string& running, const std::string& compiled, const std::string& newest)
{
  if (Release(running) != Release(compiled))
  {
    return "the module was compiled against VTK " + compiled + ", but VTK " + running +
      " draws: two VTKs are loaded, and the program may crash or draw wrong pictures";
  }
  if (Release(running) > Release(newest))
  {
    return "VTK " + running + " is newer than " + newest +
      ", the newest that this module was tested with; look at the picture before you trust it";
  }
  return "";
}

void WarnWith(const std::string& remark)
{
  if (!remark.empty())
  {
    vtkGenericWarningMacro(<< remark);
  }
}

void WarnOfVtk()
{
  static std::once_flag said;
  std::call_once(said,
    [] { WarnWith(RemarkOnVtk(vtkVersion::GetVTKVersion(), VTK_VERSION, WIDEFOV_NEWEST_VTK)); });
}
}
