// SPDX-License-Identifier: BSD-3-Clause
// Multiple Projection Common Data Interchange, versions 1 and 2: an archive with a description and
// with maps for each region, which is one projector.
// Source: VESA, MPCDI 2.0; what nDisplay and VESA's library read; Christie's notes on frames.
#include "FileText.h"
#include "Readers.h"
#include "ZipFile.h"

#include <pugixml.hpp>

#include <algorithm>
#include <map>

namespace wfv::displays
{
namespace
{
// Metres of the units.
const std::map<std::string, double> Units{ { "mm", 1e-3 }, { "cm", 1e-2 }, { "dm", 0.1 },
  { "m", 1 }, { "in", 0.0254 }, { "ft", 0.3048 }, { "yd", 0.9144 } };

// Largest deviation of a frame's axes from orthonormal. Files have five digits.
constexpr double FrameSlack = 1e-3;

struct Description
{
  const std::string& Path;
  pugi::xml_node Root;
  std::string Profile; // 2d, 3d, a3 or sl
  const PartReader& Parts;
};

[[noreturn]] void Fail(const Description& d, const pugi::xml_node& region, const std::string& text)
{
  throw FileError(
    d.Path + ": region '" + region.attribute("id").value() + "' " + text + "; export it again");
}

// Names of attributes differ in case from program to program.
std::string Attribute(const pugi::xml_node& element, const std::string& name)
{
  for (const pugi::xml_attribute& attribute : element.attributes())
  {
    if (LowerCase(attribute.name()) == name)
    {
      return attribute.value();
    }
  }
  return "";
}

double Number(const Description& d, const pugi::xml_node& region, const std::string& text,
  const std::string& what)
{
  double value = 0;
  Numbers numbers(text);
  if (!numbers.Next(value) || !numbers.Remainder().empty() || !std::isfinite(value))
  {
    Fail(d, region, "needs a number for " + what);
  }
  return value;
}

double Child(const Description& d, const pugi::xml_node& region, const pugi::xml_node& element,
  const std::string& name)
{
  return Number(d, region, element.child_value(name.c_str()), name);
}

vec3 Axis(const Description& d, const pugi::xml_node& region, const pugi::xml_node& frame,
  const std::string& name)
{
  return vec3(Child(d, region, frame, name + "x"), Child(d, region, frame, name + "y"),
    Child(d, region, frame, name + "z"));
}

Frustum ReadFrustum(const Description& d, const pugi::xml_node& region)
{
  const pugi::xml_node element = region.child("frustum");
  if (!element)
  {
    Fail(d, region, "has no frustum, which the profile " + d.Profile + " needs");
  }
  const auto angle = [&](const char* name) { return Child(d, region, element, name); };
  Frustum frustum =
    FrustumOfAngles(angle("leftAngle"), angle("rightAngle"), angle("downAngle"), angle("upAngle"));
  CheckFrustum(d.Path, frustum);
  frustum.Rotation = RotationAbout(1, -angle("yaw")) * RotationAbout(0, angle("pitch")) *
    RotationAbout(2, -angle("roll"));
  return frustum;
}

// Rows: the axes to the right, up and behind of the region's frame, in the file's coordinates.
glm::dmat3 ReadFrame(const Description& d, const pugi::xml_node& region, vec3& position)
{
  const pugi::xml_node frame = region.child("coordinateFrame");
  if (!frame)
  {
    Fail(d, region, "has no coordinateFrame, which the profile sl needs");
  }
  const vec3 right = Axis(d, region, frame, "pitch");
  const vec3 down = Axis(d, region, frame, "yaw");
  const vec3 ahead = Axis(d, region, frame, "roll");
  const glm::dmat3 axes = glm::transpose(glm::dmat3(right, -down, -ahead));
  const glm::dmat3 product = axes * glm::transpose(axes);
  for (int i = 0; i < 9; i++)
  {
    if (!(std::abs(product[i / 3][i % 3] - (i % 4 == 0 ? 1 : 0)) <= FrameSlack))
    {
      Fail(d, region, "has a coordinateFrame whose axes are not at right angles");
    }
  }
  position = axes * Axis(d, region, frame, "pos");
  return axes;
}

pugi::xml_node FindFiles(const Description& d, const std::string& region)
{
  return d.Root.find_node([&](const pugi::xml_node& node) {
    return std::string(node.name()) == "fileset" && Attribute(node, "region") == region;
  });
}

// The bytes of the file that an element of the set names; empty: it names none.
std::string ReadPart(const Description& d, const pugi::xml_node& element, std::string& name)
{
  name = std::string(Trimmed(element.child_value("path")));
  if (name.empty())
  {
    return "";
  }
  if (PointsOutside(name))
  {
    throw FileError(d.Path + ": the path '" + name + "' points outside of the archive");
  }
  return d.Parts(name);
}

void ReadMasks(const Description& d, const pugi::xml_node& region, const pugi::xml_node& files,
  Calibration& calibration)
{
  std::string name;
  const pugi::xml_node alpha = files.child("alphaMap");
  const std::string first = ReadPart(d, alpha, name);
  if (!first.empty())
  {
    calibration.Alpha = ReadPng(d.Path + ", " + name, first);
  }
  const std::string gamma(Trimmed(alpha.child_value("gammaEmbedded")));
  calibration.Gamma = gamma.empty() ? 1 : Number(d, region, gamma, "gammaEmbedded");
  if (!(calibration.Gamma > 0))
  {
    Fail(d, region, "has a gammaEmbedded that is not above 0");
  }
  const std::string second = ReadPart(d, files.child("betaMap"), name);
  if (!second.empty())
  {
    calibration.Beta = ReadPng(d.Path + ", " + name, second);
  }
  if (!std::string(files.child("distortionMap").child_value("path")).empty())
  {
    calibration.Notes.push_back(d.Path + ": the distortionMap of region '" + calibration.Name +
      "' is not read; the geometryWarpFile says what its pixels show");
  }
}

// Points of the file to metres of the room.
void ToRoom(const Description& d, const pugi::xml_node& warp, const glm::dmat3& axes,
  Calibration& calibration)
{
  const std::string unit(Trimmed(warp.child_value("geometricUnit")));
  const auto found = Units.find(unit);
  if (found == Units.end())
  {
    calibration.Notes.push_back(d.Path + ": the points of region '" + calibration.Name +
      "' have no unit; they are taken as metres");
  }
  const double scale = found == Units.end() ? 1 : found->second;
  for (vec3& point : calibration.Pixels.Values)
  {
    point = axes * point * scale;
  }
  const std::string origin(Trimmed(warp.child_value("originOf3DData")));
  if (d.Profile == "a3" && origin != "idealEyePoint")
  {
    calibration.Notes.push_back(d.Path + ": the origin of region '" + calibration.Name + "' is " +
      (origin.empty() ? "unknown" : origin) +
      ", not the eye; the display file has to place the eye");
  }
}

void ReadWarp(const Description& d, const pugi::xml_node& region, const pugi::xml_node& files,
  const glm::dmat3& axes, Calibration& calibration)
{
  const pugi::xml_node warp = files.child("geometryWarpFile");
  std::string name;
  const std::string bytes = ReadPart(d, warp, name);
  const bool points = calibration.What == Shows::Point;
  if (bytes.empty() && points && d.Profile != "sl")
  {
    Fail(d, region, "has no geometryWarpFile, which the profile " + d.Profile + " needs");
  }
  if (bytes.empty() && points)
  {
    return; // the lens alone
  }
  if (bytes.empty())
  {
    calibration.Mesh.Nodes = { { vec2(-1, -1), vec3(0, 0, 0) }, { vec2(1, -1), vec3(1, 0, 0) },
      { vec2(-1, 1), vec3(0, 1, 0) }, { vec2(1, 1), vec3(1, 1, 0) } };
    AddGrid(calibration.Mesh, 2, 2);
    return;
  }
  calibration.Pixels = ReadPfm(d.Path + ", " + name, bytes);
  CheckPixels(d.Path + ", " + name, calibration);
  if (points)
  {
    ToRoom(d, warp, axes, calibration);
  }
  const std::string interpolation(Trimmed(warp.child_value("interpolation")));
  if (interpolation == "smooth" || interpolation == "keystone")
  {
    calibration.Notes.push_back(d.Path + ": the interpolation " + interpolation + " of region '" +
      calibration.Name + "' is taken as linear");
  }
}

Calibration ReadRegion(const Description& d, const pugi::xml_node& region)
{
  Calibration calibration;
  calibration.Name = region.attribute("id").value();
  for (int i = 0; i < 2; i++)
  {
    const std::string name = i == 0 ? "xresolution" : "yresolution";
    calibration.Size[i] =
      static_cast<int>(CountOf(Number(d, region, Attribute(region, name), name)));
    if (calibration.Size[i] == 0)
    {
      Fail(d, region, "has no " + name + " of whole pixels");
    }
  }
  glm::dmat3 axes(1);
  calibration.What = d.Profile == "2d" || d.Profile == "3d" ? Shows::Picture : Shows::Point;
  if (d.Profile == "3d")
  {
    calibration.Content = ReadFrustum(d, region);
  }
  if (d.Profile == "sl")
  {
    calibration.Lens = ReadFrustum(d, region);
    axes = ReadFrame(d, region, calibration.Lens->Position);
  }
  const pugi::xml_node files = FindFiles(d, calibration.Name);
  ReadWarp(d, region, files, axes, calibration);
  ReadMasks(d, region, files, calibration);
  return calibration;
}

// The profile of the file as its shortest name.
std::string ProfileOf(const std::string& path, const pugi::xml_node& root)
{
  const std::string said = LowerCase(Attribute(root, "profile"));
  const std::string profile = said == "a3d" ? "a3" : said;
  const std::vector<std::string> known{ "2d", "3d", "a3", "sl" };
  if (std::find(known.begin(), known.end(), profile) == known.end())
  {
    throw FileError(path + " has the profile '" + said + "'; 2d, 3d, a3 and sl are supported");
  }
  const std::string version = Attribute(root, "version");
  if (version.empty() || (version[0] != '1' && version[0] != '2'))
  {
    throw FileError(path + " has the version '" + version + "'; 1 and 2 are supported");
  }
  return profile;
}
}

std::vector<Calibration> ReadMpcdi(
  const std::string& path, const std::string& xml, const PartReader& parts)
{
  pugi::xml_document document;
  const pugi::xml_parse_result result = document.load_buffer(xml.data(), xml.size());
  const pugi::xml_node root = document.document_element();
  if (!result || std::string(root.name()) != "MPCDI")
  {
    throw FileError(path + ": its description is no XML with the root MPCDI; export it again");
  }
  const Description d{ path, root, ProfileOf(path, root), parts };
  std::vector<Calibration> calibrations;
  for (const pugi::xml_node& buffer : root.child("display").children("buffer"))
  {
    for (const pugi::xml_node& region : buffer.children("region"))
    {
      calibrations.push_back(ReadRegion(d, region));
    }
  }
  if (calibrations.empty())
  {
    throw FileError(path + " has no region: it is cut, or empty; export it again");
  }
  return calibrations;
}

std::vector<Calibration> ReadMpcdiArchive(const std::string& path)
{
  const ZipFile archive(path);
  std::string description;
  for (const std::string& name : archive.Names())
  {
    const std::string lower = LowerCase(name);
    const bool isXml = lower.size() > 4 && lower.compare(lower.size() - 4, 4, ".xml") == 0;
    description = isXml && (description.empty() || lower == "mpcdi.xml") ? name : description;
  }
  if (description.empty())
  {
    throw FileError(path + " has no mpcdi.xml: it is no MPCDI archive; check the file");
  }
  return ReadMpcdi(
    path, archive.Read(description), [&](const std::string& name) { return archive.Read(name); });
}
}
