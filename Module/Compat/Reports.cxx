// SPDX-License-Identifier: BSD-3-Clause
#include "Compat/Reports.h"

#include <mutex>
#include <set>

namespace wfv
{
namespace
{
std::mutex& Lock()
{
  static std::mutex lock;
  return lock;
}

std::set<std::string>& Said()
{
  static std::set<std::string> said;
  return said;
}
}

bool IsNews(const std::string& text)
{
  const std::lock_guard<std::mutex> guard(Lock());
  return Said().insert(text).second;
}

void ForgetReports()
{
  const std::lock_guard<std::mutex> guard(Lock());
  Said().clear();
}
}
