// SPDX-License-Identifier: BSD-3-Clause
#include "DisplayFile.h"

#include "FileText.h"
#include "JsonReader.h"
#include "Readers.h"

#include <filesystem>
#include <set>

namespace wfv::displays
{
namespace
{
// Metres: the largest room.
constexpr double Largest = 1e6;

// Pixels along a side of a projector.
constexpr double MostPixels = 32768;

// Returns the path of a file that a display file names, relative to the display file.
std::string Beside(const std::string& display, const std::string& name)
{
  return (std::filesystem::path(display).parent_path() / name).string();
}

ContentView ReadPicture(const nlohmann::json& value, const std::string& where)
{
  const JsonObject object(value, where, { "projection", "hfov", "vfov", "tilt", "aspect" });
  ContentView view;
  const std::string name = object.Text("projection");
  view.Map = FindProjection(name);
  if (!view.Map || view.Map->Axis == Family::Sampled)
  {
    object.Fail("projection", "the name of a projection, such as azimuthal-equidistant");
  }
  const double across = object.Number("hfov", 0.001, 360, 180);
  view.Options.HorizontalFov = across;
  view.Options.VerticalFov = object.Number("vfov", 0.001, 360, across);
  view.Options.Tilt = object.Number("tilt", -180, 180, 0);
  view.Options.Aspect = object.Number("aspect", 0.001, 1000, 1);
  const std::string problem = CheckOptions(*view.Map, view.Options);
  if (!problem.empty())
  {
    throw FileError(where + ": " + problem);
  }
  return view;
}

template <typename Kind>
std::shared_ptr<const Surface> Round(const JsonObject& object, double usual)
{
  auto surface = std::make_shared<Kind>();
  surface->Center = object.Vector("center", vec3(0));
  surface->Radius = object.Number("radius", 1e-3, Largest);
  surface->HalfAngle = 0.5 * object.Number("angle", 1e-3, 360, usual);
  if constexpr (std::is_same_v<Kind, SphereSurface>)
  {
    const vec3 axis = object.Vector("axis", vec3(0, 1, 0));
    if (!(glm::length(axis) > 0))
    {
      object.Fail("axis", "a vector that is not zero");
    }
    surface->Axis = glm::normalize(axis);
  }
  else
  {
    surface->Low = object.Number("low", -Largest, Largest);
    surface->High = object.Number("high", surface->Low, Largest);
  }
  return surface;
}

std::shared_ptr<const Surface> Plane(const JsonObject& object)
{
  auto plane = std::make_shared<PlaneSurface>();
  plane->LowerLeft = object.Vector("lower-left");
  plane->LowerRight = object.Vector("lower-right");
  plane->UpperRight = object.Vector("upper-right");
  const vec3 right = plane->LowerRight - plane->LowerLeft;
  const vec3 up = plane->UpperRight - plane->LowerRight;
  const double slack = 1e-3 * glm::length(right) * glm::length(up);
  if (!(std::abs(glm::dot(right, up)) < slack))
  {
    object.Fail("upper-right", "a corner at right angles to the lower edge");
  }
  return plane;
}

std::shared_ptr<const Surface> ReadSurface(
  const std::string& path, const nlohmann::json& value, const std::string& where)
{
  const JsonObject any(value, where,
    { "type", "center", "radius", "axis", "angle", "low", "high", "lower-left", "lower-right",
      "upper-right", "file" });
  const std::string type = any.Text("type");
  if (type == "sphere")
  {
    return Round<SphereSurface>(
      JsonObject(value, where, { "type", "center", "radius", "axis", "angle" }), 360);
  }
  if (type == "cylinder")
  {
    return Round<CylinderSurface>(
      JsonObject(value, where, { "type", "center", "radius", "angle", "low", "high" }), 360);
  }
  if (type == "plane")
  {
    return Plane(JsonObject(value, where, { "type", "lower-left", "lower-right", "upper-right" }));
  }
  if (type == "mesh")
  {
    return displays::ReadSurface(
      Beside(path, JsonObject(value, where, { "type", "file" }).Text("file")));
  }
  any.Fail("type", "sphere, cylinder, plane or mesh");
}

Content ReadLens(const JsonObject& lens, const std::array<int, 2>& size)
{
  const vec2 pixels(size[0], size[1]);
  if (lens.Has("camera-matrix"))
  {
    const std::vector<double> c = lens.Numbers("camera-matrix", 4);
    CameraLens camera;
    camera.Focal = vec2(c[0], c[1]);
    camera.Axis = vec2(c[2], c[3]);
    camera.Size = pixels;
    if (!(c[0] > 0 && c[1] > 0))
    {
      lens.Fail("camera-matrix", "fx, fy, cx and cy, the first two above 0");
    }
    if (lens.Has("distortion"))
    {
      const std::vector<double> d = lens.Numbers("distortion", camera.Distortion.size());
      std::copy(d.begin(), d.end(), camera.Distortion.begin());
    }
    return camera;
  }
  const std::vector<double> shift =
    lens.Has("shift") ? lens.Numbers("shift", 2) : std::vector<double>{ 0, 0 };
  return ThrowLens(
    lens.Number("throw-ratio", 0.01, 1000), pixels.x / pixels.y, vec2(shift[0], shift[1]));
}

Projector ReadPlace(
  const nlohmann::json& value, const std::string& where, const std::array<int, 2>& size)
{
  const JsonObject lens(value, where,
    { "position", "direction", "up", "throw-ratio", "shift", "camera-matrix", "distortion" });
  Projector projector;
  projector.Position = lens.Vector("position");
  const vec3 direction = lens.Vector("direction");
  const vec3 up = lens.Vector("up", vec3(0, 1, 0));
  if (!(glm::length(glm::cross(direction, up)) > 1e-6 * glm::length(direction) * glm::length(up)))
  {
    lens.Fail("up", "a vector that is not along the direction");
  }
  projector.Rotation = LookAlong(direction, up);
  projector.Lens = ReadLens(lens, size);
  return projector;
}

std::array<int, 2> ReadSize(const JsonObject& object)
{
  if (!object.Has("size"))
  {
    return { { 0, 0 } };
  }
  const std::vector<double> size = object.Numbers("size", 2);
  for (const double side : size)
  {
    if (!(side >= 2 && side <= MostPixels && side == std::floor(side)))
    {
      object.Fail("size", "whole pixels from 2 to 32768");
    }
  }
  return { { static_cast<int>(size[0]), static_cast<int>(size[1]) } };
}

std::array<int, 4> ReadWindow(const JsonObject& object)
{
  const std::vector<double> w = object.Numbers("window", 4);
  for (const double number : w)
  {
    if (!(std::abs(number) <= MostPixels && number == std::floor(number)))
    {
      object.Fail("window", "x, y, width and height in whole pixels");
    }
  }
  return { { static_cast<int>(w[0]), static_cast<int>(w[1]), static_cast<int>(w[2]),
    static_cast<int>(w[3]) } };
}

SphereMirror ReadMirror(const nlohmann::json& value, const std::string& where)
{
  const JsonObject object(value, where, { "center", "radius" });
  return { object.Vector("center"), object.Number("radius", 1e-3, Largest) };
}

// The files and the geometry of a projector.
void ReadSource(
  const std::string& path, const JsonObject& object, const Surface* surface, DisplayProjector& p)
{
  if (object.Has("calibration") == object.Has("lens"))
  {
    object.Fail("calibration", "to be there, or 'lens', and not both");
  }
  if (object.Has("calibration"))
  {
    p.Calibration = Beside(path, object.Text("calibration"));
    p.Region = object.Has("region") ? object.Text("region") : "";
    return;
  }
  if (p.Size[0] == 0)
  {
    object.Fail("size", "to be there, for a lens says no pixels");
  }
  if (!surface)
  {
    object.Fail("lens", "a 'surface' of the display");
  }
  p.Place = ReadPlace(object.At("lens"), object.Where("lens"), p.Size);
  if (object.Has("mirror"))
  {
    p.Mirror = ReadMirror(object.At("mirror"), object.Where("mirror"));
  }
}

DisplayProjector ReadProjector(const std::string& path, const nlohmann::json& value,
  const std::string& where, const Surface* surface)
{
  const JsonObject object(value, where,
    { "name", "size", "machine", "monitor", "window", "calibration", "region", "lens", "mirror",
      "mask", "mask-gamma", "gamma", "black-level" });
  DisplayProjector p;
  p.Name = object.Text("name");
  if (p.Name.find('/') != std::string::npos)
  {
    object.Fail("name", "no slash: it becomes part of the names of files");
  }
  p.Size = ReadSize(object);
  p.Machine = object.Text("machine", std::string());
  p.Monitor = static_cast<int>(object.Number("monitor", 0, 1000, -1.));
  if (object.Has("window"))
  {
    p.Window = ReadWindow(object);
  }
  p.Gamma = object.Number("gamma", 0.1, 10, 2.2);
  p.BlackLevel = object.Number("black-level", 0, 0.5, 0);
  p.Mask = object.Has("mask") ? Beside(path, object.Text("mask")) : "";
  p.MaskGamma = object.Number("mask-gamma", 0.1, 10, p.Gamma);
  ReadSource(path, object, surface, p);
  return p;
}

// One name a projector, and one monitor of one machine, unless all on it have windows.
void CheckProjectors(const std::string& path, const std::vector<DisplayProjector>& projectors)
{
  for (const DisplayProjector& a : projectors)
  {
    for (const DisplayProjector& b : projectors)
    {
      const std::string both = path + ": the projectors " + a.Name + " and " + b.Name;
      if (&a < &b && a.Name == b.Name)
      {
        throw FileError(path + " has two projectors " + a.Name + "; give each a name of its own");
      }
      const bool together = a.Monitor >= 0 && a.Monitor == b.Monitor && a.Machine == b.Machine;
      if (&a < &b && together && !(a.Window && b.Window))
      {
        throw FileError(both + " are both on monitor " + std::to_string(a.Monitor) +
          "; give each a monitor, or a window of it");
      }
    }
  }
}
}

DisplayFile ReadDisplay(const std::string& path)
{
  const nlohmann::json json = ParseJson(path, ReadBytes(path));
  const JsonObject object(json, path, { "eye", "picture", "surface", "projectors" });
  DisplayFile display;
  display.Path = path;
  display.Eye = object.Vector("eye", vec3(0));
  if (object.Has("picture"))
  {
    display.Picture = ReadPicture(object.At("picture"), object.Where("picture"));
  }
  if (object.Has("surface"))
  {
    display.Lit = ReadSurface(path, object.At("surface"), object.Where("surface"));
  }
  const nlohmann::json& projectors = object.At("projectors");
  if (!projectors.is_array() || projectors.empty())
  {
    object.Fail("projectors", "a list of one projector at least");
  }
  for (std::size_t i = 0; i < projectors.size(); i++)
  {
    const std::string where = object.Where("projectors") + "[" + std::to_string(i) + "]";
    display.Projectors.push_back(ReadProjector(path, projectors[i], where, display.Lit.get()));
  }
  CheckProjectors(path, display.Projectors);
  return display;
}
}
