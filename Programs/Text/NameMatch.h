// SPDX-License-Identifier: BSD-3-Clause
// Names as people type them: in any case, by another name, with a letter wrong.
#ifndef WideFoVNameMatch_h
#define WideFoVNameMatch_h

#include <string>
#include <utility>
#include <vector>

namespace widefov
{
// Another name of one of the names.
using Alias = std::pair<std::string, std::string>;

// The one of the names that the text means: the name or an alias of it in any case, with blanks or
// underscores for hyphens. Empty where there is none.
std::string MatchName(const std::string& text, const std::vector<std::string>& names,
  const std::vector<Alias>& aliases = {});

// The name or alias that the text is likely a slip of; empty where none is near.
std::string NearestName(const std::string& text, const std::vector<std::string>& names,
  const std::vector<Alias>& aliases = {});

// ", did you mean NAME", or nothing: what follows that there is no such name.
std::string DidYouMean(const std::string& nearest);
}

#endif
