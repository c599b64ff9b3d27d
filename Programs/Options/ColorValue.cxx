// SPDX-License-Identifier: BSD-3-Clause
#include "ColorValue.h"

#include "Text/Messages.h"
#include "Text/OptionValues.h"

#include <vtkColor.h>
#include <vtkNamedColors.h>
#include <vtkNew.h>
#include <vtkStringArray.h>

#include <algorithm>

namespace widefov
{
namespace
{
// #rgb and #rrggbb.
bool IsHexadecimal(const std::string& value)
{
  return (value.size() == 4 || value.size() == 7) && value[0] == '#' &&
    value.find_first_not_of("0123456789abcdefABCDEF", 1) == std::string::npos;
}

std::vector<std::string> NamesIn(vtkNamedColors* colors)
{
  vtkNew<vtkStringArray> all;
  colors->GetColorNames(all);
  std::vector<std::string> names;
  for (vtkIdType i = 0; i < all->GetNumberOfValues(); i++)
  {
    names.push_back(all->GetValue(i));
  }
  return names;
}

Vector3 NamedColor(const std::string& option, const std::string& value)
{
  vtkNew<vtkNamedColors> colors;
  if (!IsHexadecimal(value) && !colors->ColorExists(value))
  {
    FailUsage(option + ": there is no colour '" + value + "'" +
      DidYouMean(NearestName(value, NamesIn(colors))) +
      "; give three numbers in [0, 1], #rrggbb, or a name such as slategray");
  }
  const vtkColor4ub c = colors->HTMLColorToRGBA(value);
  return { { c[0] / 255., c[1] / 255., c[2] / 255. } };
}
}

Vector3 ParseColor(const std::string& option, const std::string& value)
{
  if (value.find(',') == std::string::npos)
  {
    return NamedColor(option, value);
  }
  const std::vector<double> rgb = ParseNumbers(option, value, 3, 3);
  if (std::any_of(rgb.begin(), rgb.end(), [](double c) { return c < 0 || c > 1; }))
  {
    FailUsage(option + ": '" + value + "' is not three numbers in [0, 1]");
  }
  return { { rgb[0], rgb[1], rgb[2] } };
}
}
