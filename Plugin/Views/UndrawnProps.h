// SPDX-License-Identifier: BSD-3-Clause
// What a wide view cannot show where it belongs, and says so.
#ifndef WideFoVPluginUndrawnProps_h
#define WideFoVPluginUndrawnProps_h

#include <string>
#include <vector>

class vtkRenderer;

namespace wfvplugin
{
class UndrawnProps
{
public:
  // One line for each kind that is visible now and was not when it was last asked.
  std::vector<std::string> Look(vtkRenderer* renderer);

private:
  std::vector<bool> Said; // one a kind
};
}

#endif
