// SPDX-License-Identifier: BSD-3-Clause
// Data from standard input.
#ifndef WideFoVStandardInput_h
#define WideFoVStandardInput_h

#include "OutputFiles.h"

#include <optional>
#include <string>
#include <vector>

namespace widefov
{
// Standard input as a file that VTK's readers can open, while this lives. Its format is told by
// how it begins: VTK's own, PLY, STL or binary glTF.
class StandardInput
{
public:
  // Of the names the one that is "-" becomes that of the file. Throws a Failure with ExitUsage
  // where there are two, with ExitFailed where nothing comes, or nothing that is known.
  explicit StandardInput(std::vector<std::string>& names);
  ~StandardInput() = default;
  StandardInput(const StandardInput&) = delete;
  StandardInput& operator=(const StandardInput&) = delete;

private:
  std::optional<TemporaryFolder> Folder;
};

// The ending, such as ".vtp", for data that begin so; empty where it is not known.
std::string EndingOfData(const std::string& beginning);
}

#endif
