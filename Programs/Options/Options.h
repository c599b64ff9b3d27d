// SPDX-License-Identifier: BSD-3-Clause
// The command line of a program that draws a scene, as plain values.
#ifndef WideFoVOptions_h
#define WideFoVOptions_h

#include "Film.h"
#include "Frame/Technique.h"
#include "HeadPose.h"
#include "LensFile.h"
#include "Projections/Projection.h"
#include "Scenes/Look.h"
#include "ScreensFile.h"
#include "Stereo/Stereo.h"

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace widefov
{
// Those of the module by their numbers, and stock VTK's pass.
enum class Technique
{
  Auto = wfv::TechniqueAuto,
  Exact = wfv::TechniqueExact,
  PreClip = wfv::TechniquePreClip,
  Vertex = wfv::TechniqueVertex,
  CubeMap
};

// Those that are offered.
std::vector<std::string> TechniqueNames();

// Auto where nothing has that name.
Technique TechniqueOf(const std::string& name);

// A picture that is a part of a larger one: the larger one's size, and where the part begins, from
// its lower left corner; pixels.
struct PartOfPicture
{
  std::array<int, 2> Whole{ { 0, 0 } };
  std::array<int, 2> Start{ { 0, 0 } };
  std::array<double, 2> From{ { 0, 0 } }; // the same in shares of the whole, before rounding
  std::array<double, 2> Share{ { 1, 1 } };
};

// How bright a projector shows each pixel, in linear light; the bottom row first.
struct ProjectorLight
{
  std::vector<float> Brightness; // 0 to 1
  std::vector<float> Lift;       // added; empty: none
  double Gamma = 2.2;
};

// The film of a web page, in its folder.
constexpr const char* WebFilm = "film.mp4";

// Everything a user can ask for; the defaults are those of the command line. Angles in
// degrees, distances in scene units.
struct Options
{
  std::vector<std::string> Files;
  std::string Scene;          // a built-in scene instead of files
  std::optional<double> Time; // of data that change; none: the first step
  std::string Config;         // file of options that the command line does not give
  std::string Preset;         // gives those that neither gives; empty: none

  std::string Projection = "equirectangular";
  bool HasProjection = false;
  bool HasFov = false;   // any field of view
  wfv::ViewOptions View; // complete after ParseOptions; Radii only where HasClip
  bool HasClip = false;
  std::string DirectionMap;     // file of the projection of that name
  std::string Warp;             // file of a projector's calibration; empty: none
  std::string Projectors;       // file of a display; empty: none
  std::string Projector;        // the only one of these that is drawn; empty: all of a display
  double ProjectorGamma = 2.2;  // of --warp
  std::string ContentMap;       // of --warp: the projection that the calibration refers to
  wfv::ViewOptions ContentView; // and its numbers
  std::shared_ptr<const ProjectorLight> Light; // of a picture for a projector; nullptr: full
  std::string ProjectorName;                   // of one of several pictures; empty: the only one
  std::string LensFile;                        // of a calibrated camera
  std::vector<double> Circle;  // of a round map: its centre and radius, pixels of the picture
  std::vector<double> Borders; // of what is seen: left, right, down, up from the axis; empty: even
  std::optional<PartOfPicture> Part; // that these are; View has the larger picture's fields of view
  std::optional<CalibratedLens> UnevenLens; // one that is no round map: LoadDirectionMap makes one
  bool HasSize = false;
  std::array<int, 2> Size{ { 2048, 1024 } };
  std::optional<std::array<int, 2>> Tile; // none: only what cannot be drawn at once is in tiles

  std::optional<Vector3> Eye; // none: the centre of the scene
  std::optional<Vector3> LookAt;
  std::optional<Vector3> Direction; // neither: -z
  std::optional<Vector3> Up;        // none: +y
  bool Inside = false;              // where the eye is; neither: as the data lie (FirstView.h)
  bool Outside = false;

  widefov::Technique Technique = Technique::Auto;
  std::string TechniqueName = "auto";
  int CubeMapResolution = 300;
  double Tolerance = 0.25; // pixels
  bool ExactPerspective = false;
  int Samples = 4;
  std::string Depth = "linear";
  bool DebugView = false;
  bool Overlay = false;                      // what the pass counted, as text on the picture
  std::string Stereo = wfv::NoStereo().Name; // its numbers are in View
  std::string Layout = "anaglyph";
  std::array<int, 2> AnaglyphMask{ { 4, 3 } }; // what each eye has: 4 red, 2 green, 1 blue
  double AnaglyphSaturation = 0.65;            // 0 grey, 1 full colours
  bool EyesByDepth = false;                    // --ipd auto
  bool ConvergeOnDepth = false;                // --convergence auto, --offset auto
  double FloatingWindow = 0;                   // width of a bar, fraction of the picture's width
  double Letterbox = 0;                        // height of a bar, fraction of the picture's height
  std::vector<std::string> StereoGiven;        // stereo options on the command line

  std::string Screens;               // file of flat screens; perspective
  std::string Poses;                 // file of head poses
  double RoomScale = 1;              // scene units a unit of the room
  std::optional<NamedScreen> Screen; // what one picture of several shows (Sights.h)
  std::optional<HeadPose> Head;      // whom it is for
  std::optional<std::size_t> Number; // of the pose, where there are several

  widefov::Look Look;                       // colours, glyphs
  std::vector<double> ScalarBarAt;          // azimuth, elevation, depth; empty: in the picture
  Vector3 Background{ { 0, 0, 0 } };        // red, green, blue, 0 to 1
  std::optional<Vector3> Zenith;            // none: as the background
  std::string Sky;                          // file of a picture of all directions
  vtkSmartPointer<vtkImageData> SkyPicture; // LoadSky

  std::vector<std::string> Outputs;
  std::string Aov;
  std::string Stats;
  std::string DumpShaders; // a folder; empty: none
  std::string Web;         // folder of a web page; empty: none
  std::string Title;       // of the web page; empty: the name of the data
  int Frames = 0;          // 0: one frame, no warm-up

  FilmOptions Film;

  bool ListProjections = false;
  bool ListScenes = false;
  bool ListFormats = false;
  bool ListPresets = false;
  bool Info = false;
  bool Json = false;
  bool Version = false;
  bool Quiet = false;
  bool Verbose = false;
  bool DryRun = false;    // say what would be drawn, and end
  std::string ListArrays; // of this file; empty: of none
};
}

#endif
