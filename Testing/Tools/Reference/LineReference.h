// SPDX-License-Identifier: BSD-3-Clause
// What a picture of lines must show, in double: the image of every line sampled so densely
// that consecutive samples are a tenth of a pixel apart, and the distance of the pixel
// centres from it. It shares nothing with the shaders but the view's `forward`. On the faces of
// a cube each shows the lines as its own map would if it went on beyond the face's borders. A
// map that shows the half sphere ahead shows no part of a line behind it. Where the rays of an eye
// begin in several places, each point of a line is where its own ray sees it.
#ifndef WideFoVLineReference_h
#define WideFoVLineReference_h

#include "Projections/Projection.h"
#include "TriangleSoup.h"

#include <limits>
#include <unordered_map>
#include <vector>

namespace wfv
{
namespace reference
{
// One straight line, view coordinates.
struct Segment
{
  vec3 From{ 0 };
  vec3 To{ 0 };
  vtkIdType Cell = -1; // in the polydata
};

// The pieces of all line cells of a polydata.
std::vector<Segment> Segments(vtkPolyData* polyData, const Pose& worldToView);

// A line near a pixel.
struct NearLine
{
  vtkIdType Cell = -1;
  double Distance = std::numeric_limits<double>::infinity(); // of the centre, pixels
  double RhoMin = std::numeric_limits<double>::infinity();   // from the eye, scene units, over
  double RhoMax = 0; // the points of the line that are nearest but for a slack
};

// Pixels: points of a line so much farther from a pixel than the nearest one may be taken
// for it.
constexpr double NearestSlack = 0.02;

// Radians: a line whose plane is so near the axis of the map runs through the pole.
constexpr double ThroughPole = 1e-6;

// The lines that come within `reach` pixels of each pixel's centre; the key is j * width + i,
// rows from the top. The clip spheres have no part in it.
using LinePicture = std::unordered_map<long, std::vector<NearLine>>;

LinePicture RenderLines(const std::vector<Segment>& segments, const View& view, int width,
  int height, double reach, double nearest = NearestSlack);
}
}

#endif
