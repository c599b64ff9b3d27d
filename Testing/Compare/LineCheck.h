// SPDX-License-Identifier: BSD-3-Clause
// Pictures of lines beside the reference in double: every pixel whose centre is nearer to a line
// than half its width is drawn, none that is farther, with the cell and the distance of the
// nearest line's nearest point; within what the technique may err by.
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

// How a technique may differ from the reference.
struct LineRules
{
  int Technique;
  double Inside;  // pixels: what is nearer than half the width by more is drawn
  double Outside; // pixels: what is farther than half the width by more is not
  double Nearest; // pixels: points that are farther by less than this may be taken for the nearest
  double Depth;   // relative, of the distance from the eye
  double Beyond;  // times the range of the nearest points' distances: the last pixel's is beyond it
  bool Gaps;      // the hardware leaves a few pixels out, or draws them, at joints and ends
};

// Of exact strips.
LineRules StripRules();

// Of chords by the hardware, so many pixels wide, with the technique auto.
LineRules ChordRules(double width);

// Draws the scene and asserts the picture; prints a row.
LineResult CheckLines(Drawing& drawing, const Shot& shot, const LineScene& scene, double width,
  const LineRules& rules = StripRules());
}
}

#endif
