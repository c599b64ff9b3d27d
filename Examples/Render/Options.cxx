// SPDX-License-Identifier: BSD-3-Clause
// Every option is declared here, once: name, type, range, default, text.
#include "Options.h"

#include "ColorMaps.h"
#include "Messages.h"
#include "OptionCheck.h"
#include "OptionValues.h"

#include <CLI/CLI.hpp>

#include <functional>
#include <iostream>

namespace widefov
{
namespace
{
constexpr double Most = 1e18; // squares of it still fit a float32
const Range FieldOfView{ 0, 360, true };

// Declares options of one group.
class Group
{
public:
  Group(CLI::App& app, const std::string& title)
    : App(app)
    , Title(title)
  {
  }

  using Setter = std::function<void(const std::string& option, const std::string& text)>;

  CLI::Option* Add(const std::string& name, const std::string& type, const std::string& standard,
    const std::string& text, const Setter& set)
  {
    const std::string last = name.substr(name.rfind(',') + 1);
    return this->App
      .add_option_function<std::string>(
        name, [last, set](const std::string& value) { set(last, value); }, text)
      ->type_name(type)
      ->default_str(standard)
      ->group(this->Title);
  }

  void Number(const std::string& name, const std::string& type, double& target, const Range& range,
    const std::string& text)
  {
    this->Add(name, type, Text(target), text + ", " + range.Describe(),
      [&target, range](const std::string& option, const std::string& value) {
        target = ParseNumber(option, value, range);
      });
  }

  void Integer(const std::string& name, int& target, int low, int high, const std::string& text)
  {
    const std::string range = Range{ double(low), double(high) }.Describe();
    this->Add(name, "N", std::to_string(target), text + ", " + range,
      [&target, low, high](const std::string& option, const std::string& value) {
        target = ParseInteger(option, value, low, high);
      });
  }

  void Vector(const std::string& name, std::optional<Vector3>& target, const std::string& standard,
    const std::string& text)
  {
    this->Add(name, "X,Y,Z", standard, text,
      [&target](const std::string& option, const std::string& value) {
        const std::vector<double> v = ParseNumbers(option, value, 3, 3);
        for (const double component : v)
        {
          if (std::abs(component) > Most)
          {
            FailUsage(option + ": '" + value + "' is beyond 1e18");
          }
        }
        target = Vector3{ { v[0], v[1], v[2] } };
      });
  }

  void Choice(const std::string& name, std::string& target, const std::vector<std::string>& choices,
    const std::vector<std::string>& later, const std::string& text)
  {
    this->Add(name, "NAME", target, text + ": " + Join(choices),
      [&target, choices, later](const std::string& option, const std::string& value) {
        CheckChoice(option, value, choices, later);
        target = value;
      });
  }

  void Name(
    const std::string& name, const std::string& type, std::string& target, const std::string& text)
  {
    this->Add(
      name, type, target, text, [&target](const std::string& option, const std::string& value) {
        if (value.empty())
        {
          FailUsage(option + " needs a name, not an empty text");
        }
        target = value;
      });
  }

  // Part of the contract, not built yet.
  void Later(const std::string& name, const std::string& type, const std::string& text)
  {
    this->Add(name, type, "", text + " (comes with a later version)",
      [](const std::string& option, const std::string&) {
        FailUsage(option + " comes with a later version; leave it out");
      });
  }

  void Flag(const std::string& name, bool& target, const std::string& text)
  {
    this->App.add_flag(name, target, text)->group(this->Title);
  }

private:
  CLI::App& App;
  std::string Title;
};

void ParseSize(const std::string& option, const std::string& text, std::array<int, 2>& size)
{
  constexpr int Largest = 1 << 24; // the display's own limit is asked later
  const std::size_t cross = text.find('x');
  if (cross == std::string::npos)
  {
    FailUsage(option + ": '" + text + "' is not WIDTHxHEIGHT, such as 2048x1024");
  }
  size[0] = ParseInteger(option, text.substr(0, cross), 1, Largest);
  size[1] = ParseInteger(option, text.substr(cross + 1), 1, Largest);
}

void DeclareView(CLI::App& app, Options& o, FieldsOfView& fov)
{
  Group group(app, "View");
  group.Name("--projection", "NAME", o.Projection, "the map; --list-projections prints them");
  const auto angle = [](std::optional<double>& target) {
    return [&target](const std::string& option, const std::string& value) {
      target = ParseNumber(option, value, FieldOfView);
    };
  };
  group.Add("--hfov", "DEG", "360", "horizontal field of view, degrees", angle(fov.Horizontal));
  group.Add("--vfov", "DEG", "180", "vertical field of view, degrees", angle(fov.Vertical));
  group.Add(
    "--fov", "DEG", "360", "field of view of a round projection, degrees", angle(fov.Round));
  group.Add("--lens", "C1,..,C5", "", "fisheye lens: r = c1 t + .. + c5 t^5, t in radians",
    [&fov](const std::string& option, const std::string& value) {
      fov.Lens = ParseNumbers(option, value, 1, 5);
    });
  group.Number("--tilt", "DEG", o.View.Tilt, { -180, 180 }, "how far the axis is raised");
  group.Add("--size", "WxH", "2048x1024", "pixels",
    [&o](
      const std::string& option, const std::string& value) { ParseSize(option, value, o.Size); });
  group.Vector("--eye", o.Eye, "centre of the scene", "where the camera is");
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

void DeclareDrawing(CLI::App& app, Options& o)
{
  Group group(app, "Drawing");
  group.Choice("--technique", o.TechniqueName,
    { "auto", "exact", "tessellate", "preclip", "vertex", "cubemap" }, {}, "how it is drawn");
  group.Integer("--cubemap-resolution", o.CubeMapResolution, 1, 16384, "pixels a cube face");
  group.Number("--tolerance", "PX", o.Tolerance, { 0.001, 1e6 },
    "largest distance between a drawn edge and its true curve, pixels");
  group.Integer("--samples", o.Samples, 0, 64, "multisampling; 0 or 1 is off");
  group.Choice("--depth", o.Depth, { "linear", "log", "reversed" }, {}, "depth mapping");
  group.Flag("--debug-view", o.DebugView, "primitives coloured by what happened to them");
}

void DeclareStereo(CLI::App& app, Options& o)
{
  Group group(app, "Stereo");
  group.Choice(
    "--stereo", o.Stereo, { "mono" }, { "warped", "omnidirectional", "offaxis" }, "stereo model");
  group.Add("--layout", "NAME", "", "where the eyes go (comes with a later version)",
    [](const std::string& option, const std::string& value) {
      CheckChoice(option, value, {}, { "left", "right", "side-by-side", "top-bottom", "anaglyph" });
    });
  group.Later("--ipd", "D", "distance between the eyes");
  group.Later("--pole-fade", "A,B", "latitudes between which the offset fades");
  group.Later("--iod", "D", "warped: distance between the eyes");
  group.Later("--distance", "D", "warped: distance of the viewer");
  group.Later("--offset", "D", "warped: plane of zero parallax");
  group.Later("--separation", "F", "offaxis: fraction of the screen's width");
  group.Later("--convergence", "D", "offaxis: distance of zero parallax");
  group.Later("--screens", "FILE.pvx", "flat screens of a wall or CAVE");
  group.Later("--pose", "FILE", "recorded head poses");
}

void DeclareData(CLI::App& app, Options& o)
{
  Group group(app, "Data");
  group.Name("--scene", "NAME", o.Scene, "a built-in scene; --list-scenes prints them");
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
  group.Flag("--scalar-bar", o.Look.ScalarBar, "draw the colour map's bar into the picture");
  group.Add("--background", "R,G,B", "0,0,0", "colour where there is nothing, 0 to 1",
    [&o](const std::string& option, const std::string& value) {
      const std::vector<double> rgb = ParseNumbers(option, value, 3, 3);
      for (std::size_t i = 0; i < 3; i++)
      {
        if (rgb[i] < 0 || rgb[i] > 1)
        {
          FailUsage(option + ": '" + value + "' is not three numbers in [0, 1]");
        }
        o.Background[i] = rgb[i];
      }
    });
  group.Name("--vectors", "NAME", o.Look.Vectors, "arrow glyphs of this vector array");
  group.Name("--streamlines", "NAME", o.Look.StreamLines, "stream tubes of this vector array");
}

void DeclareOutput(CLI::App& app, Options& o)
{
  Group group(app, "Output");
  app.add_option("-o,--output", o.Outputs, "picture: .png .jpg .tif .exr; repeatable")
    ->type_name("FILE")
    ->allow_extra_args(false)
    ->group("Output");
  group.Name("--aov", "FILE.exr", o.Aov, "distance, cell, prop, normal beside the colour");
  group.Integer("--frames", o.Frames, 1, 1000000, "frames to time, after two warm-up frames");
  group.Name("--stats", "FILE.json", o.Stats, "timings and counts");
  group.Flag("--list-projections", o.ListProjections, "print the projections");
  group.Flag("--list-scenes", o.ListScenes, "print the built-in scenes");
  group.Flag("--json", o.Json, "lists as JSON");
  group.Flag("--version", o.Version, "print the version");
}
}

std::optional<int> ParseOptions(int argc, char** argv, Options& options)
{
  CLI::App app("Pictures of VTK data in wide and non-planar projections.", "widefov-render");
  FieldsOfView fov;
  app.add_option("FILE", options.Files, "data to draw, in any format that VTK reads");
  DeclareData(app, options);
  DeclareView(app, options, fov);
  DeclareDrawing(app, options);
  DeclareStereo(app, options);
  DeclareOutput(app, options);
  try
  {
    app.parse(argc, argv);
  }
  catch (const CLI::CallForHelp&)
  {
    std::cout << app.help() << std::flush;
    CheckStandardOutput();
    return ExitDone;
  }
  catch (const CLI::ParseError& error)
  {
    FailUsage(std::string(error.what()) + "; widefov-render --help lists the options");
  }
  CheckTogether(options, fov);
  return std::nullopt;
}
}
