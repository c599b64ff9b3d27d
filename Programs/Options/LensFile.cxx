// SPDX-License-Identifier: BSD-3-Clause
#include "LensFile.h"

#include "System/SmallFile.h"
#include "Text/Messages.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <sstream>
#include <vector>

namespace widefov
{
namespace
{
// The centre of the first pixel, in OpenCV's pixels, is 0, 0.
constexpr double HalfPixel = 0.5;

using LensNumbers = std::vector<double>;

[[noreturn]] void Refuse(const std::string& path, const std::string& why)
{
  FailUsage(path + ": " + why + "; check the calibration");
}

// One model of COLMAP: where in a line's numbers OpenCV's are. -1: it has none.
struct ColmapModel
{
  const char* Name;
  LensModel Model;
  std::size_t Count;
  bool OneFocal;
  std::array<int, 8> Coefficients; // OpenCV's order
  UnevenKind Kind = UnevenKind::OpenCv;
};

constexpr std::array<int, 8> None{ { -1, -1, -1, -1, -1, -1, -1, -1 } };

const ColmapModel ColmapModels[] = {
  { "SIMPLE_PINHOLE", LensModel::BrownConrady, 3, true, None },
  { "PINHOLE", LensModel::BrownConrady, 4, false, None },
  { "SIMPLE_RADIAL", LensModel::BrownConrady, 4, true, { { 3, -1, -1, -1, -1, -1, -1, -1 } } },
  { "RADIAL", LensModel::BrownConrady, 5, true, { { 3, 4, -1, -1, -1, -1, -1, -1 } } },
  { "OPENCV", LensModel::BrownConrady, 8, false, { { 4, 5, 6, 7, -1, -1, -1, -1 } } },
  { "FULL_OPENCV", LensModel::BrownConrady, 12, false, { { 4, 5, 6, 7, 8, 9, 10, 11 } } },
  { "OPENCV_FISHEYE", LensModel::Fisheye, 8, false, { { 4, 5, 6, 7, -1, -1, -1, -1 } } },
  { "SIMPLE_RADIAL_FISHEYE", LensModel::Fisheye, 4, true, { { 3, -1, -1, -1, -1, -1, -1, -1 } } },
  { "RADIAL_FISHEYE", LensModel::Fisheye, 5, true, { { 3, 4, -1, -1, -1, -1, -1, -1 } } },
  { "FOV", LensModel::BrownConrady, 5, false, { { 4, -1, -1, -1, -1, -1, -1, -1 } },
    UnevenKind::Fov },
  { "THIN_PRISM_FISHEYE", LensModel::BrownConrady, 12, false, { { 4, 5, 6, 7, 8, 9, 10, 11 } },
    UnevenKind::PrismFisheye },
};

const ColmapModel& FindModel(
  const std::string& path, const std::string& id, const std::string& name)
{
  std::string known;
  for (const ColmapModel& m : ColmapModels)
  {
    if (name == m.Name)
    {
      return m;
    }
    known += (known.empty() ? "" : ", ") + std::string(m.Name);
  }
  FailUsage(path + ": camera " + id + " has the model " + name + "; there are " + known);
}

CalibratedLens FromNumbers(const ColmapModel& model, const LensNumbers& n)
{
  const LensNumbers p(n.begin() + 2, n.end());
  const std::size_t axis = model.OneFocal ? 1 : 2;
  CalibratedLens lens;
  lens.Model = model.Model;
  lens.Kind = model.Kind;
  lens.Size = wfv::vec2(n[0], n[1]);
  lens.Focal = wfv::vec2(p[0], p[axis - 1]);
  lens.Axis = wfv::vec2(p[axis], p[axis + 1]);
  for (std::size_t i = 0; i < model.Coefficients.size(); i++)
  {
    lens.Coefficients[i] = model.Coefficients[i] < 0 ? 0 : p[model.Coefficients[i]];
  }
  if (lens.Kind == UnevenKind::Fov && lens.Coefficients[0] == 0)
  {
    lens.Kind = UnevenKind::OpenCv; // a field of view of 0 is a pinhole
  }
  return lens;
}

// A camera of COLMAP: ID MODEL WIDTH HEIGHT and the model's numbers.
CalibratedLens FromColmap(const std::string& path, const std::string& line)
{
  std::istringstream words(line);
  std::string id;
  std::string name;
  LensNumbers n;
  words >> id >> name;
  for (std::string word; words >> word;)
  {
    char* end = nullptr;
    n.push_back(std::strtod(word.c_str(), &end));
    if (*end != 0)
    {
      Refuse(path, "camera " + id + " has '" + word + "' where a number belongs");
    }
  }
  const ColmapModel& model = FindModel(path, id, name);
  if (n.size() != model.Count + 2)
  {
    Refuse(path,
      "camera " + id + " needs a width, a height and " + std::to_string(model.Count) +
        " numbers of " + name + ", not " + std::to_string(n.size()) + " in all");
  }
  return FromNumbers(model, n);
}

// The lines of COLMAP's cameras; empty: the text is none of COLMAP's.
std::vector<std::string> ColmapLines(const std::string& text)
{
  std::vector<std::string> lines;
  std::istringstream all(text);
  for (std::string line; std::getline(all, line);)
  {
    std::istringstream words(line);
    long id = 0;
    std::string model;
    if (line.empty() || line[0] == '#' || line.find_first_not_of(" \t\r") == std::string::npos)
    {
      continue;
    }
    if (!(words >> id >> model) || !std::isupper(static_cast<unsigned char>(model[0])))
    {
      return {};
    }
    lines.push_back(line);
  }
  return lines;
}

CalibratedLens ChooseColmap(
  const std::string& path, const std::vector<std::string>& lines, const std::string& id)
{
  std::string ids;
  for (const std::string& line : lines)
  {
    std::string own;
    std::istringstream(line) >> own;
    ids += (ids.empty() ? "" : ", ") + own;
    if (id == own || (id.empty() && lines.size() == 1))
    {
      return FromColmap(path, line);
    }
  }
  FailUsage(path + " has the cameras " + ids + (id.empty() ? "" : ", none " + id) + "; write " +
    path + "#ID for one of them");
}

// The first of these keys that a file has.
YAML::Node FindKey(const YAML::Node& root, const std::vector<std::string>& keys)
{
  for (const std::string& key : keys)
  {
    if (const YAML::Node found = root[key])
    {
      return found;
    }
  }
  return YAML::Node(YAML::NodeType::Undefined);
}

// A matrix as OpenCV and ROS write it, or rows in rows.
void AddNumbers(const std::string& path, const YAML::Node& node, LensNumbers& numbers)
{
  if (node.IsMap())
  {
    const std::size_t before = numbers.size();
    AddNumbers(path, node["data"], numbers);
    const std::size_t count = numbers.size() - before;
    if (node["rows"] && node["cols"] &&
      node["rows"].as<double>() * node["cols"].as<double>() != static_cast<double>(count))
    {
      Refuse(path,
        "a matrix of " + node["rows"].as<std::string>() + " rows and " +
          node["cols"].as<std::string>() + " columns has " + std::to_string(count) + " numbers");
    }
  }
  else if (node.IsSequence())
  {
    for (const YAML::Node& part : node)
    {
      AddNumbers(path, part, numbers);
    }
  }
  else
  {
    numbers.push_back(node.as<double>());
  }
}

LensNumbers NumbersOf(
  const std::string& path, const YAML::Node& root, const std::vector<std::string>& keys)
{
  const YAML::Node node = FindKey(root, keys);
  if (!node)
  {
    Refuse(path, "it has no " + keys.front());
  }
  LensNumbers numbers;
  AddNumbers(path, node, numbers);
  return numbers;
}

wfv::vec2 SizeOf(const std::string& path, const YAML::Node& root)
{
  const std::vector<std::string> both{ "image_size", "imageSize", "resolution" };
  if (FindKey(root, both))
  {
    const LensNumbers size = NumbersOf(path, root, both);
    if (size.size() != 2)
    {
      Refuse(path, "the size of its picture is not two numbers");
    }
    return wfv::vec2(size[0], size[1]);
  }
  const LensNumbers width = NumbersOf(path, root, { "image_width", "image_Width", "width" });
  const LensNumbers height = NumbersOf(path, root, { "image_height", "image_Height", "height" });
  if (width.size() != 1 || height.size() != 1)
  {
    Refuse(path, "the size of its picture is not two numbers");
  }
  return wfv::vec2(width[0], height[0]);
}

std::optional<LensModel> ModelOf(const std::string& path, const YAML::Node& root)
{
  if (const YAML::Node fisheye = FindKey(root, { "fisheye_model", "fisheye" }))
  {
    const std::string value = fisheye.as<std::string>();
    return value != "0" && value != "false" ? LensModel::Fisheye : LensModel::BrownConrady;
  }
  const YAML::Node node = FindKey(root, { "distortion_model", "camera_model", "model" });
  if (!node)
  {
    return std::nullopt;
  }
  const std::string name = node.as<std::string>();
  const auto is = [&name](const std::vector<std::string>& names) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  if (is({ "equidistant", "fisheye", "kannala_brandt", "kannala_brandt4", "opencv_fisheye" }))
  {
    return LensModel::Fisheye;
  }
  if (!is({ "plumb_bob", "rational_polynomial", "radtan", "pinhole", "brown_conrady", "opencv" }))
  {
    Refuse(path, "its model '" + name + "' is neither plumb_bob, rational_polynomial nor fisheye");
  }
  return LensModel::BrownConrady;
}

// The matrix as nine numbers; of Kalibr it has four: fx, fy, cx, cy.
LensNumbers MatrixOf(const std::string& path, const YAML::Node& root)
{
  if (!root["intrinsics"])
  {
    return NumbersOf(path, root, { "camera_matrix", "Camera_Matrix", "cameraMatrix", "K" });
  }
  const LensNumbers n = NumbersOf(path, root, { "intrinsics" });
  const std::string model =
    root["camera_model"] ? root["camera_model"].as<std::string>() : "pinhole";
  if (model != "pinhole" || n.size() != 4)
  {
    Refuse(path,
      "its camera_model '" + model + "' with " + std::to_string(n.size()) +
        " intrinsics is not drawn; Kalibr's pinhole has four");
  }
  return { n[0], 0, n[2], 0, n[1], n[3], 0, 0, 1 };
}

// The element of a camera: Kalibr's files have one for each, cam0, cam1; others have none.
YAML::Node CameraOf(const std::string& path, const YAML::Node& root, const std::string& id)
{
  std::string ids;
  std::map<std::string, YAML::Node> cameras;
  for (const auto& entry : root)
  {
    const auto name = entry.first.as<std::string>();
    if (name.rfind("cam", 0) == 0 && entry.second.IsMap() && entry.second["intrinsics"])
    {
      ids += (ids.empty() ? "" : ", ") + name;
      cameras.emplace(name, entry.second);
    }
  }
  const auto found = cameras.size() == 1 && id.empty() ? cameras.begin() : cameras.find(id);
  if (cameras.empty() || found != cameras.end())
  {
    return cameras.empty() ? root : found->second;
  }
  FailUsage(path + " has the cameras " + ids + (id.empty() ? "" : ", none " + id) + "; write " +
    path + "#ID for one of them");
}

CalibratedLens FromYaml(const std::string& path, const YAML::Node& file, const std::string& id)
{
  if (!file.IsMap())
  {
    FailUsage(path + " is no calibration; give one of OpenCV (YAML) or COLMAP (cameras.txt)");
  }
  const YAML::Node root = CameraOf(path, file, id);
  CalibratedLens lens;
  lens.Model = ModelOf(path, root);
  lens.Size = SizeOf(path, root);
  const LensNumbers k = MatrixOf(path, root);
  if (k.size() != 9 || k[1] != 0 || k[3] != 0 || k[6] != 0 || k[7] != 0 || k[8] != 1)
  {
    Refuse(path, "its camera matrix is not fx, 0, cx, 0, fy, cy, 0, 0, 1");
  }
  lens.Focal = wfv::vec2(k[0], k[4]);
  lens.Axis = wfv::vec2(k[2], k[5]) + HalfPixel;
  const LensNumbers d = NumbersOf(path, root,
    { "distortion_coefficients", "Distortion_Coefficients", "distortion_coeffs", "distCoeffs",
      "dist_coeffs", "D" });
  const std::size_t most = lens.Coefficients.size();
  if (std::any_of(d.begin() + std::min(most, d.size()), d.end(), [](double v) { return v != 0; }))
  {
    Refuse(path, "it has thin prism or tilt coefficients, which are not drawn");
  }
  std::copy(d.begin(), d.begin() + std::min(most, d.size()), lens.Coefficients.begin());
  return lens;
}

// OpenCV's first line is no YAML: "%YAML:1.0".
CalibratedLens ParseYaml(const std::string& path, const std::string& text, const std::string& id)
{
  const bool own = text.rfind("%YAML", 0) == 0;
  const std::string rest = own ? text.substr(std::min(text.size(), text.find('\n'))) : text;
  try
  {
    return FromYaml(path, YAML::Load(rest), id);
  }
  catch (const YAML::RepresentationException& e)
  {
    Refuse(path,
      "line " + std::to_string(e.mark.line + 1) + " has something else where a number belongs");
  }
  catch (const YAML::Exception& e)
  {
    // its own words quote what may be no text
    Refuse(path, "it is no calibration: line " + std::to_string(e.mark.line + 1) + " is not YAML");
  }
}
}

CalibratedLens ReadLensFile(const std::string& given)
{
  // FILE#ID, unless there is a file of that whole name
  const std::size_t mark = given.rfind('#');
  std::error_code error;
  const bool whole = mark == std::string::npos || std::filesystem::exists(given, error);
  const std::string path = whole ? given : given.substr(0, mark);
  const std::string id = whole ? "" : given.substr(mark + 1);
  const std::string text =
    ReadSmallFile(path, "give a calibration of OpenCV (YAML) or COLMAP (cameras.txt)");
  const std::vector<std::string> lines = ColmapLines(text);
  CalibratedLens lens = lines.empty() ? ParseYaml(path, text, id) : ChooseColmap(path, lines, id);
  std::vector<double> all{ lens.Size.x, lens.Size.y, lens.Focal.x, lens.Focal.y, lens.Axis.x,
    lens.Axis.y };
  all.insert(all.end(), lens.Coefficients.begin(), lens.Coefficients.end());
  if (!std::all_of(all.begin(), all.end(), [](double v) { return std::isfinite(v); }))
  {
    Refuse(path, "it has a number that is not finite");
  }
  return lens;
}
}
