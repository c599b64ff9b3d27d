// SPDX-License-Identifier: BSD-3-Clause
// One measured run, and its JSON.
#ifndef WideFoVRecord_h
#define WideFoVRecord_h

#include "Metrics.h"
#include "Motion.h"
#include "Options/Options.h"
#include "System/Spread.h"

#include <nlohmann/json.hpp>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace wfv
{
namespace bench
{
using Json = nlohmann::ordered_json;

// What to measure: a method as it is called in the JSON, and everything that draws it.
struct Run
{
  std::string Method;              // auto, .., cubemap, cubemap-ss, perspective, floor
  std::optional<double> Parameter; // tolerance in pixels, or pixels a cube face
  widefov::Options Options;        // projection, size, technique, camera
  bench::Motion Motion;            // of the camera, before each frame
  std::string DirectionsOf;        // the projection that a direction map is of
};

struct ErrorFigures
{
  reference::Metrics Metrics;
  double Tolerance = 0;  // b, pixels
  bool HasDepth = false; // the method shows distances
};

// What a frame takes, milliseconds: until it is drawn, and of all processors together.
struct FrameTime
{
  double Passed = 0;
  double Processor = 0;
};

struct Record
{
  std::string Scene;
  long long Triangles = 0;
  bench::Run Run;
  std::vector<double> Milliseconds; // one a frame: FrameTime::Passed
  std::vector<double> ProcessorMilliseconds;
  std::optional<double> FirstMilliseconds; // of the first frame of a new window
  std::optional<ErrorFigures> Error;
  std::optional<long> Covered;        // pixels with something in them
  std::optional<long long> Fragments; // runs of fragment programs in a frame, all passes
  std::string Note;                   // why something is missing
};

// Figures that are not known are null.
Json ToJson(const Record& record);

// The median of the frames, none where nothing was timed.
std::optional<double> MedianOf(const Record& record);

// "auto_0.25", "cubemap_652", "exact"
std::string NameOf(const Run& run);
}
}

#endif
