// SPDX-License-Identifier: BSD-3-Clause
// Contents of projector calibration files: the place of a picture, or the point of the surface,
// that each place of a projector's picture shows. Pure mathematics and files, no VTK.
#ifndef WideFoVCalibration_h
#define WideFoVCalibration_h

#include "Projections/ProjectionMath.h"

#include <array>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace wfv::displays
{
// One line that names a file, says what is wrong with it, and where.
class FileError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

// The meaning of the three numbers that a place of a projector's picture has.
enum class Shows
{
  Picture,   // u to the right and v upwards, 0 to 1, in a picture; the third number is unused
  Point,     // a point of the surface, metres, room coordinates: x right, y up, looking down -z
  Direction, // a unit vector in the same coordinates
};

// Values of all pixels, the bottom row first. NaN: the pixel shows nothing.
struct Raster
{
  int Width = 0; // pixels
  int Height = 0;
  std::vector<vec3> Values;
};

// Grey values 0 to 1 as a file stores them, the bottom row first. No pixels: there is no mask.
struct Mask
{
  int Width = 0; // pixels
  int Height = 0;
  std::vector<float> Values;
};

struct WarpNode
{
  vec2 At;               // place in the projector's picture, NDC: -1 to 1, y up
  vec3 Shown;            // by the calibration's Shows
  double Brightness = 1; // 0 to 1 as the file stores it
};

// Values and brightness are linear within each triangle.
struct WarpMesh
{
  std::vector<WarpNode> Nodes;
  std::vector<std::array<std::uint32_t, 3>> Triangles; // indices of nodes
  bool HalfHeights = false; // At.x is in half heights of the picture: -aspect to aspect
};

// A perspective picture. Tangents of its borders' angles; Left < Right and Down < Up.
struct Frustum
{
  double Left = -1;
  double Right = 1;
  double Down = -1;
  double Up = 1;
  glm::dmat3 Rotation{ 1 };        // from the picture's coordinates to the room's
  vec3 Position{ 0 };              // of the projector in the room, metres, for profile SL
  vec3 PlaneShift{ 0 };            // added to the picture's plane at the distance PlaneDistance
  double PlaneDistance = 1;        // in the units of PlaneShift
  vec3 DirectionAt(vec2 uv) const; // unit vector of a place u, v
};

// The calibration of one projector.
struct Calibration
{
  std::string Path;                // of the file, for messages
  std::string Name;                // of an MPCDI region; otherwise empty
  std::array<int, 2> Size{ 0, 0 }; // pixels of the projector; 0: the file does not say
  Shows What = Shows::Picture;
  WarpMesh Mesh;                  // a mesh, or
  Raster Pixels;                  // a value a pixel
  std::optional<Frustum> Content; // the picture that u and v refer to, if the file says it
  std::optional<Frustum> Lens;    // the projector's own, of profile SL
  double Gamma = 1;               // linear brightness is the stored one to this power, or to:
  static constexpr double ProjectorGamma = 0; // that of the projector
  Mask Alpha;                                 // multiplied
  Mask Beta;                                  // black level that is added
  std::vector<std::string> Notes;             // what the file asks for and is not done, a line each
};

// Reads all projectors of a file, told by its ending: .mpcdi, .data, .obj, .pfm, .sgc, .txt or
// .skyskan (SkySkan), .xml or .simcad (SimCAD, or an unpacked MPCDI), .ol, .csv. Throws FileError.
std::vector<Calibration> ReadCalibrations(const std::string& path);

// The projector of this name; empty: the only one of the file. Throws a FileError.
Calibration ReadCalibration(const std::string& path, const std::string& name);
}

#endif
