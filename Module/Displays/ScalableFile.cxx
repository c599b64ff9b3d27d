// SPDX-License-Identifier: BSD-3-Clause
// The meshes of Scalable Display Technologies, "OPENMESH": lines of a word and its value, a line
// "x y intensity s t" a node, pixels and 0 to 255, a line "[ a b c ]" a triangle.
// Source: what SGCT reads (sgct/sgct, src/correction).
#include "FileText.h"
#include "Readers.h"

#include <map>

namespace wfv::displays
{
namespace
{
constexpr double FullIntensity = 255;

// Distance of the picture's plane that the offsets of the perspective move, as SGCT has it.
constexpr double PlaneAt = 10;

// Words that change what the mesh shows, and their only value that is read.
const std::map<std::string, std::string> Demanded{ { "mapping", "normalized" },
  { "sampling", "linear" }, { "projection", "perspective" }, { "frustum_euler_angles", "0" },
  { "use_sphere_sample_coordinate_system", "0" }, { "do_no_warp", "0" } };

// Words that ask for a picture beside the mesh, which the display file names.
constexpr std::array<std::string_view, 3> Beside{ { "apply_mask", "apply_black_level",
  "apply_color" } };

using Words = std::map<std::string, std::string>;

double Number(const std::string& path, const Words& words, const std::string& word, double usual)
{
  const auto found = words.find(word);
  double value = usual;
  if (found != words.end() && (!Numbers(found->second).Next(value) || !std::isfinite(value)))
  {
    throw FileError(path + ": '" + found->second + "' of " + word + " is no number");
  }
  return value;
}

void AddNode(const Lines& lines, WarpMesh& mesh)
{
  const std::array<double, 5> n = lines.Finite<5>("five numbers: x, y, intensity, s and t");
  mesh.Nodes.push_back({ vec2(n[0], n[1]), vec3(1 - n[4], 1 - n[3], 0), n[2] / FullIntensity });
}

void AddTriangle(const Lines& lines, WarpMesh& mesh)
{
  std::array<double, 3> t{};
  Numbers numbers(lines.Text().substr(1));
  if (!numbers.All(t) || CountOf(t[0] + 1) * CountOf(t[1] + 1) * CountOf(t[2] + 1) == 0)
  {
    lines.Fail("needs three numbers of nodes in brackets");
  }
  mesh.Triangles.push_back({ { static_cast<std::uint32_t>(t[0]), static_cast<std::uint32_t>(t[1]),
    static_cast<std::uint32_t>(t[2]) } });
}

void AddWord(const Lines& lines, Words& words)
{
  const std::string_view text = lines.Text();
  const std::size_t end = std::min(text.find_first_of(" \t"), text.size());
  const std::string word = LowerCase(text.substr(0, end));
  const std::string value = LowerCase(Trimmed(text.substr(end)));
  const auto demanded = Demanded.find(word);
  if (demanded != Demanded.end() && demanded->second != value)
  {
    lines.Fail("only '" + demanded->second + "' is supported; export the mesh so");
  }
  words[word] = value;
}

Words ReadLines(const std::string& path, const std::string& bytes, WarpMesh& mesh)
{
  Lines lines(path, bytes);
  Words words;
  while (lines.Next())
  {
    double number = 0;
    if (lines.Text()[0] == '[')
    {
      AddTriangle(lines, mesh);
    }
    else if (Numbers(lines.Text()).Next(number))
    {
      AddNode(lines, mesh);
    }
    else
    {
      AddWord(lines, words);
    }
  }
  return words;
}

// Throws unless the file has as many as it says; it need not say.
void CheckCount(
  const std::string& path, const Words& words, const std::string& word, std::size_t there)
{
  const double said = Number(path, words, word, double(there));
  if (said != double(there))
  {
    throw FileError(path + " has " + std::to_string(there) + " " + word + " and says " +
      words.at(word) + ": it is cut; get the whole file");
  }
}

Frustum View(const std::string& path, const Words& words)
{
  const auto number = [&](const char* word) {
    return Number(path, words, std::string("perspective_") + word, 0);
  };
  Frustum frustum =
    FrustumOfAngles(number("left"), number("right"), number("bottom"), number("top"));
  CheckFrustum(path, frustum);
  frustum.Rotation = RotationAbout(2, number("roll")) * RotationAbout(1, number("yaw")) *
    RotationAbout(0, number("pitch"));
  frustum.PlaneShift = vec3(number("xoffset"), number("yoffset"), number("zoffset"));
  frustum.PlaneDistance = PlaneAt;
  return frustum;
}

// From pixels, and the rectangle of the picture that they are cut to, to NDC.
void PlaceNodes(const std::string& path, const Words& words, Calibration& calibration)
{
  const vec2 size(Number(path, words, "nativexres", 0), Number(path, words, "nativeyres", 0));
  const vec2 low(Number(path, words, "ortho_left", 0), Number(path, words, "ortho_bottom", 0));
  const vec2 high(Number(path, words, "ortho_right", 1), Number(path, words, "ortho_top", 1));
  if (CountOf(size.x) == 0 || CountOf(size.y) == 0 || high.x == low.x || high.y == low.y)
  {
    throw FileError(path + " has no NATIVEXRES and NATIVEYRES, pixels, or an empty ORTHO");
  }
  calibration.Size = { { static_cast<int>(size.x), static_cast<int>(size.y) } };
  for (WarpNode& node : calibration.Mesh.Nodes)
  {
    node.At = 2. * (node.At / size - low) / (high - low) - 1.;
  }
}
}

Calibration ReadScalable(const std::string& path, const std::string& bytes)
{
  Calibration calibration;
  const Words words = ReadLines(path, bytes, calibration.Mesh);
  if (words.count("openmesh") == 0)
  {
    throw FileError(path + " has no line OPENMESH: it is no mesh of Scalable; check the file");
  }
  CheckCount(path, words, "vertices", calibration.Mesh.Nodes.size());
  CheckCount(path, words, "faces", calibration.Mesh.Triangles.size());
  calibration.Gamma = Number(path, words, "gamma", 2.2);
  PlaceNodes(path, words, calibration);
  if (words.count("perspective_left") != 0)
  {
    calibration.Content = View(path, words);
  }
  for (const std::string_view word : Beside)
  {
    if (Number(path, words, std::string(word), 0) != 0)
    {
      calibration.Notes.push_back(path + " asks for " + std::string(word) +
        ", which is not read; name the mask and the black level in the display file");
    }
  }
  CheckMesh(path, calibration);
  return calibration;
}
}
