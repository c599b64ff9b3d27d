// SPDX-License-Identifier: BSD-3-Clause
#include "Compat/Reports.h"

#include <algorithm>
#include <cctype>
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

std::string WithoutNumbers(std::string text)
{
  text.erase(
    std::remove_if(text.begin(), text.end(), [](unsigned char c) { return std::isdigit(c) != 0; }),
    text.end());
  return text;
}

void ForgetReports()
{
  const std::lock_guard<std::mutex> guard(Lock());
  Said().clear();
}
}
