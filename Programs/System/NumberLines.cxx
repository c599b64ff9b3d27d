// SPDX-License-Identifier: BSD-3-Clause
#include "NumberLines.h"

#include "Text/Messages.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace widefov
{
namespace
{
std::vector<double> NumbersOf(const std::string& where, const std::string& line)
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
}

std::vector<NumberLine> ReadNumberLines(const std::string& path, const std::string& what)
{
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error))
  {
    Fail(path + " is not there, or no file; give " + what + " as text");
  }
  std::ifstream file(path);
  std::vector<NumberLine> lines;
  std::string line;
  for (int number = 1; std::getline(file, line); number++)
  {
    const std::size_t first = line.find_first_not_of(" \t\r");
    if (first == std::string::npos || line[first] == '#')
    {
      continue;
    }
    const std::string where = path + ", line " + std::to_string(number);
    lines.push_back({ where, NumbersOf(where, line) });
  }
  if (file.bad() || !file.eof())
  {
    Fail(path + " cannot be read; check its permissions");
  }
  return lines;
}
}
