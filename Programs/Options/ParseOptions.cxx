// SPDX-License-Identifier: BSD-3-Clause
// Every option is declared here, once: name, type, range, default, text.
#include "ParseOptions.h"

#include "ColorValue.h"
#include "Completion.h"
#include "Displays.h"
#include "FilmOptions.h"
#include "OptionCheck.h"
#include "OptionGroup.h"
#include "PresetChoice.h"
#include "RoomOptions.h"
#include "Scenes/ColorMaps.h"
#include "Scenes/Scenes.h"
#include "StereoOptions.h"
#include "Text/Messages.h"
#include "Text/OptionValues.h"
#include "Text/ProjectionNames.h"
#include "WarpOptions.h"
#include "WebOptions.h"

#include <CLI/CLI.hpp>

#include <cmath>

namespace widefov
{
namespace
{
using Group = OptionGroup;

const Range FieldOfView{ 0, 360, true };
const Range OpacityFactor{ 0.001, 1000 };

void DeclareLens(Group& group, Options& o)
{
  group.Name("--lens-file", "FILE", o.LensFile,
    "a calibrated camera: OpenCV's YAML, ROS's, or COLMAP's cameras.txt (FILE#ID for one of "
    "several)");
  group.Add("--circle", "X,Y,R", "as large as fits",
    "centre and radius of a round map, pixels of the picture from its upper left corner",
    [&o](const std::string& option, const std::string& value) {
      o.Circle = ParseNumbers(option, value, 3, 3);
    });
}

void DeclareProjection(Group& group, Options& o)
{
  group.Add("--projection", "NAME", o.Projection, "the map; --list-projections prints them",
    [&o](const std::string& option, const std::string& value) {
      o.Projection = Choose(option, value, ProjectionNames(), ProjectionAliases());
      o.HasProjection = true;
    });
  Completions()["--projection"] = ProjectionNames();
}

void DeclareAngles(Group& group, Options& o, FieldsOfView& fov)
{
  const auto angle = [](std::optional<double>& target) {
    return [&target](const std::string& option, const std::string& value) {
      target = ParseNumber(option, value, FieldOfView);
    };
  };
  group.Add("--hfov", "DEG", "360", "horizontal field of view, degrees", angle(fov.Horizontal));
  group.Add("--vfov", "DEG", "180", "vertical field of view, degrees", angle(fov.Vertical));
  group.Add(
    "--fov", "DEG", "360", "field of view of a round projection, degrees", angle(fov.Round));
  group.Add("--borders", "L,R,D,U", "even, by --hfov and --vfov",
    "angles of the picture's borders from the axis: left, right, down, up; degrees, to the left "
    "and down below 0",
    [&o](const std::string& option, const std::string& value) {
      o.Borders = ParseNumbers(option, value, 4, 4);
    });
}

void DeclareView(CLI::App& app, Options& o, FieldsOfView& fov)
{
  Group group(app, "View");
  DeclareProjection(group, o);
  DeclareAngles(group, o, fov);
  group.Add("--lens", "C1,..,C9", "",
    "lens: r = c1 t + .. + c9 t^9; t in radians, its tangent with brown-conrady",
    [&fov](const std::string& option, const std::string& value) {
      fov.Lens = ParseNumbers(option, value, 1, 9);
    });
  DeclareLens(group, o);
  group.Name("--direction-map", "FILE.exr|NAME", o.DirectionMap,
    "what the projection direction-map shows: a unit vector a pixel in X, Y, Z, or " +
      Join(DisplayNames()));
  group.Number("--tilt", "DEG", o.View.Tilt, { -180, 180 }, "how far the axis is raised");
  group.Size("--size", o.Size, "pixels");
  group.Vector("--eye", o.Eye, "as the data lie, see --inside", "where the camera is");
  group.Vector("--look-at", o.LookAt, "", "a point ahead of the camera");
  group.Vector("--direction", o.Direction, "0,0,-1", "the direction of view");
  group.Vector("--up", o.Up, "0,1,0", "what is up in the picture");
  group.Add("--clip", "NEAR,FAR", "from the scene's bounds", "radii of the clip spheres",
    [&o](const std::string& option, const std::string& value) {
      const std::vector<double> radii = ParseNumbers(option, value, 2, 2);
      o.View.Radii = { { radii[0], radii[1] } };
      o.HasClip = true;
    });
}

void DeclareTechnique(Group& group, Options& o)
{
  group.Add("--technique", "NAME", o.TechniqueName, "how it is drawn: " + Join(TechniqueNames()),
    [&o](const std::string& option, const std::string& value) {
      const bool old = !MatchName(value, { "tessellate" }, {}).empty();
      if (old)
      {
        Say("--technique tessellate is called auto; the old name goes with the next release");
      }
      o.TechniqueName = Choose(option, old ? "auto" : value, TechniqueNames(), {});
    });
  Completions()["--technique"] = TechniqueNames();
}

void DeclareDrawing(CLI::App& app, Options& o)
{
  Group group(app, "Drawing");
  DeclareTechnique(group, o);
  group.Integer("--cubemap-resolution", o.CubeMapResolution, 1, 16384, "pixels a cube face");
  group.Number("--tolerance", "PX", o.Tolerance, { 0.001, 1e6 },
    "largest distance between a drawn edge and its true curve, pixels");
  group.Flag("--exact-perspective", o.ExactPerspective,
    "the technique draws the perspective too, which is stock VTK's unless the technique is exact");
  group.Integer("--samples", o.Samples, 0, 64, "multisampling; 0 or 1 is off");
  group.Choice("--depth", o.Depth, { "linear", "log", "reversed" }, {}, "depth mapping");
  group.Flag("--debug-view", o.DebugView, "primitives coloured by what happened to them");
}

void DeclareBackground(Group& group, Options& o)
{
  group.Add("--background", "COLOUR", "0,0,0",
    "where there is nothing: R,G,B from 0 to 1, a name, or #rrggbb",
    [&o](const std::string& option, const std::string& value) {
      o.Background = ParseColor(option, value);
    });
  group.Add("--zenith", "COLOUR", "", "colour straight up; --background is that of the horizon",
    [&o](const std::string& option, const std::string& value) {
      o.Zenith = ParseColor(option, value);
    });
  group.Name("--sky", "FILE", o.Sky,
    "picture of all directions, twice as wide as high: .hdr .exr "
    ".jpg .png .tif");
}

void DeclareData(CLI::App& app, Options& o)
{
  Group group(app, "Data");
  group.Add("--scene", "NAME", "", "a built-in scene; --list-scenes prints them",
    [&o](const std::string& option, const std::string& value) {
      o.Scene = Choose(option, value, SceneNames());
    });
  Completions()["--scene"] = SceneNames();
  group.Add("--time", "T", "the first step",
    "of data that change with time, such as .pvd: the step that is seen then",
    [&o](const std::string& option, const std::string& value) {
      o.Time = ParseNumber(option, value, { -HUGE_VAL, HUGE_VAL });
    });
  group.Name("--color-by", "NAME[:COMPONENT]", o.Look.ColorBy, "array that gives the colour");
  group.Choice("--colormap", o.Look.ColorMap, ColorMapNames(), {}, "colours");
  group.Add("--range", "A,B", "of the data", "values at the ends of the colour map",
    [&o](const std::string& option, const std::string& value) {
      const std::vector<double> range = ParseNumbers(option, value, 2, 2);
      o.Look.Range = std::array<double, 2>{ { range[0], range[1] } };
    });
  group.Choice("--representation", o.Look.Representation,
    { "surface", "surface-with-edges", "wireframe", "points" }, {}, "how surfaces are drawn");
  group.Number("--line-width", "PX", o.Look.LineWidth, { 0, 100, true }, "width of lines, pixels");
  group.Number("--point-size", "PX", o.Look.PointSize, { 0, 100, true }, "size of points, pixels");
  group.Flag("--lines-as-tubes", o.Look.LinesAsTubes, "lines are round, --line-width wide");
  group.Flag("--points-as-spheres", o.Look.PointsAsSpheres, "points are round, --point-size wide");
  group.Number("--volume-opacity", "F", o.Look.VolumeOpacity, OpacityFactor,
    "of volumes: times as much light is taken on the same way");
  group.Flag("--scalar-bar", o.Look.ScalarBar, "draw the colour map's bar into the picture");
  DeclareBackground(group, o);
  group.Name("--vectors", "NAME", o.Look.Vectors, "arrow glyphs of this vector array");
  group.Name("--streamlines", "NAME", o.Look.StreamLines, "stream tubes of this vector array");
}

void DeclareScalarBar(OptionGroup& group, Options& o)
{
  group.Add("--scalar-bar-at", "AZ,EL[,DEPTH]", "",
    "the colour map's bar stands in a direction, degrees to the right and up, DEPTH scene units "
    "away (before all there is to see; two eyes need it)",
    [&o](const std::string& option, const std::string& value) {
      o.ScalarBarAt = ParseNumbers(option, value, 2, 3);
      o.Look.ScalarBar = true;
    });
}

void DeclareOutput(CLI::App& app, Options& o)
{
  Group group(app, "Output");
  DeclareScalarBar(group, o);
  app
    .add_option("-o,--output", o.Outputs,
      "picture: .png .jpg .tif .exr, - for PNG to standard output; repeatable")
    ->type_name("FILE")
    ->allow_extra_args(false)
    ->group("Output");
  group.Size("--tile", o.Tile, "only where needed", "draw the picture in tiles of that size");
  group.Name("--aov", "FILE.exr", o.Aov, "distance, cell, prop, normal beside the colour");
  group.Integer("--frames", o.Frames, 1, 1000000, "frames to time, after two warm-up frames");
  group.Name("--stats", "FILE.json", o.Stats, "timings and counts");
  group.Name(
    "--dump-shaders", "DIR", o.DumpShaders, "the text of each shader program, files in a folder");
  group.Flag("--dry-run", o.DryRun, "print what would be drawn, and draw nothing; --json");
  group.Flag("--overlay", o.Overlay, "what was drawn and left out, as text on the picture");
}

void DeclareListings(CLI::App& app, Options& o)
{
  Group group(app, "Output");
  group.Flag("--list-projections", o.ListProjections, "print the projections");
  group.Flag("--list-scenes", o.ListScenes, "print the built-in scenes");
  group.Flag("--list-formats", o.ListFormats, "print the kinds of files that are read");
  group.Name("--list-arrays", "FILE", o.ListArrays, "print the arrays of a file of data");
  group.Flag("--info", o.Info, "print what the files hold: bounds, arrays, times, triangles");
  group.Flag("--json", o.Json, "lists and --info as JSON");
  group.Flag("--version", o.Version, "print the version");
}

void DeclareFirstView(CLI::App& app, Options& o)
{
  OptionGroup group(app, "View");
  group.Flag("--inside", o.Inside, "the eye is in the middle of the data");
  group.Flag("--outside", o.Outside, "the eye is before the data, which fill the picture");
}

void DeclareFirstLook(CLI::App& app, Look& look)
{
  OptionGroup group(app, "Data");
  group.Off("--no-colors", look.Colors, "files are grey, unless --color-by says otherwise");
  group.Off("--no-scalar-bar", look.UsualBar, "no bar of colours that nobody asked for");
  group.Off("--no-smooth", look.Smooth, "surfaces without normals show their facets");
  group.Off("--no-surface", look.Surface, "--vectors and --streamlines alone");
  group.Flag("--volume", look.Volume, "data that fill space are drawn as such, not as surfaces");
  group.Off("--no-volume", look.UsualVolume, "images are drawn as surfaces");
}
}

void DeclareScene(CLI::App& app, Options& options, FieldsOfView& fov)
{
  app
    .add_option("FILE", options.Files,
      "data to draw, of a kind that --list-formats prints; - for standard input")
    ->type_name("");
  DeclareData(app, options);
  DeclareView(app, options, fov);
  DeclareFirstView(app, options);
  DeclareFirstLook(app, options.Look);
  DeclareDrawing(app, options);
  DeclareStereo(app, options);
  DeclareRoom(app, options);
  DeclarePresets(app, options);
  DeclareListings(app, options);
}

std::optional<int> ParseOptions(int argc, char** argv, Options& options)
{
  CLI::App app("Pictures of VTK data in wide and non-planar projections.", "widefov-render");
  FieldsOfView fov;
  DeclareScene(app, options, fov);
  DeclareWarp(app, options);
  DeclareOutput(app, options);
  DeclareWeb(app, options);
  DeclareFilm(app, options);
  if (const std::optional<int> done = ParseCommandLine(app, argc, argv))
  {
    return done;
  }
  CompleteFromPreset(app, options, Target::File);
  CompleteFilm(app, options);
  CompleteWeb(options);
  CheckTogether(options, fov);
  return std::nullopt;
}
}
