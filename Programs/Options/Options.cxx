// SPDX-License-Identifier: BSD-3-Clause
#include "Options.h"

#include <algorithm>

namespace widefov
{
std::vector<std::string> TechniqueNames()
{
  std::vector<std::string> names;
  for (const wfv::TechniqueEntry& technique : wfv::Techniques())
  {
    names.push_back(technique.Name);
  }
  names.emplace_back("cubemap");
  return names;
}

Technique TechniqueOf(const std::string& name)
{
  const std::vector<std::string> names = TechniqueNames();
  const auto found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? Technique::Auto : Technique(found - names.begin());
}
}
