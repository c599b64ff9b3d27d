// SPDX-License-Identifier: BSD-3-Clause
#include "HeadPose.h"

#include "Messages.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace widefov
{
namespace
{
// Lengths of a quaternion: beyond them it is no turn that somebody measured.
constexpr double LeastTurn = 1e-3;
constexpr double MostTurn = 1e3;

std::vector<double> Numbers(const std::string& where, const std::string& line)
{
  std::istringstream words(line);
  std::string word;
  std::vector<double> numbers;
  while (words >> word)
  {
    std::size_t read = 0;
    double number = 0;
    try
    {
      number = std::stod(word, &read);
    }
    catch (const std::exception&)
    {
      read = 0;
    }
    if (read != word.size() || !std::isfinite(number))
    {
      Fail(where + ": '" + OneLine(word).substr(0, 40) + "' is no finite number; correct it");
    }
    numbers.push_back(number);
  }
  return numbers;
}

HeadPose ToPose(const std::string& where, const std::vector<double>& v)
{
  if (v.size() != 8 && v.size() != 5)
  {
    Fail(where + " has " + std::to_string(v.size()) +
      " numbers; a pose is time x y z qx qy qz qw, or time qx qy qz qw");
  }
  HeadPose pose;
  pose.Time = v[0];
  pose.HasPosition = v.size() == 8;
  if (pose.HasPosition)
  {
    pose.Head.Position = { v[1], v[2], v[3] };
  }
  const std::size_t turn = v.size() - 4;
  std::copy_n(v.begin() + static_cast<std::ptrdiff_t>(turn), 4, pose.Head.Turn.begin());
  const double length =
    std::hypot(std::hypot(v[turn], v[turn + 1]), std::hypot(v[turn + 2], v[turn + 3]));
  if (!(length > LeastTurn) || !(length < MostTurn))
  {
    Fail(where + ": a quaternion of length " + Text(length) + " is no turn; correct it");
  }
  return pose;
}
}

RecordedHead::RecordedHead(const std::string& path)
{
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error))
  {
    Fail(path + " is not there, or no file; give recorded head poses as text");
  }
  std::ifstream file(path);
  std::string line;
  for (int number = 1; std::getline(file, line); number++)
  {
    const std::size_t first = line.find_first_not_of(" \t\r");
    if (first == std::string::npos || line[first] == '#')
    {
      continue;
    }
    const std::string where = path + ", line " + std::to_string(number);
    this->Poses.push_back(ToPose(where, Numbers(where, line)));
    if (this->Poses.back().HasPosition != this->Poses.front().HasPosition)
    {
      Fail(where + ": poses with and without a position are mixed; give one kind");
    }
  }
  if (file.bad() || !file.eof())
  {
    Fail(path + " cannot be read; check its permissions");
  }
  if (this->Poses.empty())
  {
    Fail(path + " has no pose; a line is time x y z qx qy qz qw, or time qx qy qz qw");
  }
}

std::optional<HeadPose> RecordedHead::Next()
{
  return this->Taken < this->Poses.size() ? std::optional(this->Poses[this->Taken++])
                                          : std::nullopt;
}
}
