// SPDX-License-Identifier: BSD-3-Clause
// Pictures of lines beside the reference in double: every pixel whose centre is nearer to a line
// than half its width is drawn, none that is farther, with the cell and the distance of the
// nearest line's nearest point.
#ifndef WideFoVLineCheck_h
#define WideFoVLineCheck_h

#include "Drawing.h"

#include <string>
#include <vector>

namespace wfv
{
namespace test
{
struct LineScene
{
  std::string Name;
  std::vector<std::vector<vec3>> Lines;
};

struct LineResult
{
  long Drawn = 0;
  long Missing = 0;
  long Spurious = 0;
  long Hidden = 0; // another line is in front
  long Depth = 0;
  double WorstDepth = 0;
  double WorstPixels = 0; // by which a missing or spurious pixel is on the wrong side
  std::string First;      // the first wrong pixel
};

// Segments in no direction in particular, short and long, near and far.
LineScene RandomLines(unsigned int seed, int count, double longest);

// One line a scene, beside all that tears or bends a map: what may go wrong shows alone.
std::vector<LineScene> NastyLines();

// As wide as the projection goes.
Shot LineShot(const std::string& projection, int width);

// Draws the scene with the technique exact and asserts the picture; prints a row.
LineResult CheckLines(Drawing& drawing, const Shot& shot, const LineScene& scene, double width);
}
}

#endif
