// SPDX-License-Identifier: BSD-3-Clause
#include "ProjectionNames.h"

#include "Projections/Projection.h"

namespace widefov
{
std::vector<std::string> ProjectionNames()
{
  std::vector<std::string> names;
  for (const wfv::Projection* p : wfv::AllProjections())
  {
    names.push_back(p->Name);
  }
  return names;
}
}
