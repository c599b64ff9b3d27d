// SPDX-License-Identifier: BSD-3-Clause
// The files that were opened last, from one run to the next.
#ifndef WideFoVRecent_h
#define WideFoVRecent_h

#include <string>
#include <vector>

namespace widefov
{
class Recent
{
public:
  // $XDG_STATE_HOME/widefov/recent, or that of ~/.local/state; empty where there is no home.
  static std::string UsualFile();

  // Keeps them in this file; empty: nowhere. One that is not there, or no text, is an empty list.
  explicit Recent(const std::string& file);

  // Whole paths, the last one that was opened first; those that are gone are left out.
  std::vector<std::string> Get() const;

  // Puts them in front. A file that cannot be written is no reason to stop.
  void Add(const std::vector<std::string>& paths);

private:
  std::string File;
};
}

#endif
