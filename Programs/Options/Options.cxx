// SPDX-License-Identifier: BSD-3-Clause
#include "Options.h"

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
  const int number = wfv::FindTechnique(name);
  return name == "cubemap" ? Technique::CubeMap : number < 0 ? Technique::Auto : Technique(number);
}
}
