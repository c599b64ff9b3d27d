// SPDX-License-Identifier: BSD-3-Clause
// A display in one file of JSON: its projectors, where they stand or how they were calibrated,
// their machines and monitors, and what they light. Documentation/displays/file.md has the words.
#ifndef WideFoVDisplayFile_h
#define WideFoVDisplayFile_h

#include "Projector.h"
#include "Projections/Projection.h"

namespace wfv::displays
{
// The picture that meshes refer to, and its numbers.
struct ContentView
{
  const Projection* Map = nullptr;
  ViewOptions Options;
};

struct DisplayProjector
{
  std::string Name;                // one of a kind
  std::array<int, 2> Size{ 0, 0 }; // pixels; 0: the calibration says
  std::string Machine;             // host name; empty: this one
  int Monitor = -1;                // from 0; -1: none named
  std::optional<std::array<int, 4>>
    Window;                       // x, y from the monitor's upper left corner, width, height
  std::string Calibration;        // path; empty: it is computed from the lens and the surface
  std::string Region;             // of the calibration; empty: its only one
  std::optional<Projector> Place; // where the projector stands; its lens has the shape of Size
  std::optional<SphereMirror> Mirror;
  std::string Mask; // path of a PNG image; empty: none
  double MaskGamma = 2.2;
  double Gamma = 2.2;
  double BlackLevel = 0; // linear light of black, of that of white
};

struct DisplayFile
{
  std::string Path;
  vec3 Eye{ 0 }; // metres, room
  std::optional<ContentView> Picture;
  std::shared_ptr<const Surface> Lit; // nullptr: none named
  std::vector<DisplayProjector> Projectors;
};

// Throws a FileError: a missing file, no JSON, an unknown word or a wrong value with its place in
// the file, names that are there twice, two projectors on one monitor.
DisplayFile ReadDisplay(const std::string& path);

// Places of a picture as a View has them.
Content ContentOfView(const Projection& projection, const ViewOptions& options);

// The tables of all projectors, with brightness and lift: by the masks of the files, or blended
// where no file has one. `notes`: what files ask for and is not done.
std::vector<Table> MakeTables(const DisplayFile& display, std::vector<std::string>& notes);
}

#endif
