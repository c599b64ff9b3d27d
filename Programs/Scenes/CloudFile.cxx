// SPDX-License-Identifier: BSD-3-Clause
#include "CloudFile.h"

#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <fstream>
#include <limits>
#include <optional>
#include <stdexcept>
#include <vector>

namespace widefov
{
namespace cloud
{
namespace
{
using Columns = std::array<std::size_t, 3>;

constexpr std::size_t MostNames = 1000; // columns: more are no cloud
constexpr double MostByte = 255;

std::vector<std::string> WordsOf(const std::string& line)
{
  const bool marked = line.find_first_of(",;") != std::string::npos;
  const std::string between = marked ? ",;" : " \t";
  std::vector<std::string> words;
  for (std::size_t begin = 0; begin <= line.size() && words.size() <= MostNames;)
  {
    const std::size_t end = std::min(line.find_first_of(between, begin), line.size());
    std::string word = line.substr(begin, end - begin);
    word.erase(0, word.find_first_not_of(" \t\r\"\xef\xbb\xbf"));
    word.erase(word.find_last_not_of(" \t\r\"") + 1);
    if (!word.empty() || marked)
    {
      words.push_back(word);
    }
    begin = end + 1;
  }
  return words;
}

// NaN for a number that is missing; nothing for another word.
std::optional<double> NumberOf(const std::string& word)
{
  if (word.empty())
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  double value = 0;
  const char* const begin = word.data() + (word[0] == '+' ? 1 : 0);
  const char* const end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(begin, end, value);
  return error == std::errc() && stop == end ? std::optional(value) : std::nullopt;
}

std::string Lower(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

// The columns of these names; nothing if one is missing.
std::optional<Columns> Find(
  const std::vector<std::string>& names, const std::array<const char*, 3>& wanted)
{
  Columns found{};
  for (std::size_t i = 0; i < 3; i++)
  {
    const auto at = std::find_if(names.begin(), names.end(),
      [&](const std::string& name) { return Lower(name) == wanted[i]; });
    if (at == names.end())
    {
      return std::nullopt;
    }
    found[i] = static_cast<std::size_t>(at - names.begin());
  }
  return found;
}

class Table
{
public:
  void Read(const std::string& path)
  {
    std::ifstream file(path);
    std::string line;
    for (long number = 1; std::getline(file, line); number++)
    {
      const std::vector<std::string> words = WordsOf(line);
      const bool blank = line.find_first_not_of(" \t\r") == std::string::npos;
      if (!blank && line[0] != '#' && line.rfind("//", 0) != 0)
      {
        this->Add(words, "line " + std::to_string(number));
      }
    }
    if (this->Values.empty())
    {
      throw std::runtime_error("it holds no points");
    }
  }

  vtkSmartPointer<vtkPolyData> MakeData() const
  {
    const std::optional<Columns> place =
      this->HasNames ? Find(this->Names, { "x", "y", "z" }) : std::optional(Columns{ { 0, 1, 2 } });
    if (!place)
    {
      throw std::runtime_error("it has no columns x, y and z");
    }
    std::vector<bool> used(this->Names.size());
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (std::size_t i = 0; i < this->Count(); i++)
    {
      points->InsertNextPoint(
        this->At(i, (*place)[0]), this->At(i, (*place)[1]), this->At(i, (*place)[2]));
    }
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(points);
    this->Mark(*place, used);
    if (const std::optional<Columns> colors = this->FindColors())
    {
      this->AddColors(data, *colors);
      this->Mark(*colors, used);
    }
    for (std::size_t c = 0; c < used.size(); c++)
    {
      if (!used[c])
      {
        this->AddArray(data, c);
      }
    }
    return data;
  }

private:
  std::size_t Count() const { return this->Values.size() / this->Names.size(); }
  double At(std::size_t row, std::size_t c) const
  {
    return this->Values[row * this->Names.size() + c];
  }

  static void Mark(const Columns& columns, std::vector<bool>& used)
  {
    for (const std::size_t c : columns)
    {
      used[c] = true;
    }
  }

  void Add(const std::vector<std::string>& words, const std::string& where)
  {
    std::vector<double> numbers;
    for (const std::string& word : words)
    {
      if (const std::optional<double> number = NumberOf(word))
      {
        numbers.push_back(*number);
      }
    }
    const bool all = numbers.size() == words.size();
    if (this->Names.empty() && all && words.size() == 1)
    {
      return; // the number of points
    }
    if (this->Names.empty())
    {
      this->Begin(words, all, where);
    }
    if (!all && this->Values.empty() && this->HasNames && words == this->Names)
    {
      return;
    }
    if (!all || numbers.size() != this->Names.size())
    {
      throw std::runtime_error(
        where + " is not " + std::to_string(this->Names.size()) + " numbers");
    }
    this->Values.insert(this->Values.end(), numbers.begin(), numbers.end());
  }

  void Begin(const std::vector<std::string>& words, bool numbers, const std::string& where)
  {
    if (words.size() < 3 || words.size() > MostNames)
    {
      throw std::runtime_error(where + " is no point of three numbers, nor names of columns");
    }
    this->HasNames = !numbers;
    this->Names = words;
    for (std::size_t i = 0; i < words.size() && numbers; i++)
    {
      this->Names[i] = "column " + std::to_string(i + 1);
    }
  }

  bool AreBytes(const Columns& columns) const
  {
    for (std::size_t i = 0; i < this->Count(); i++)
    {
      for (const std::size_t c : columns)
      {
        const double value = this->At(i, c);
        if (!(value >= 0 && value <= MostByte && value == std::floor(value)))
        {
          return false;
        }
      }
    }
    return true;
  }

  std::optional<Columns> FindColors() const
  {
    std::optional<Columns> found =
      this->HasNames ? Find(this->Names, { "red", "green", "blue" }) : std::nullopt;
    found = found || !this->HasNames ? found : Find(this->Names, { "r", "g", "b" });
    const std::size_t count = this->Names.size();
    if (!this->HasNames && (count == 6 || count == 7))
    {
      found = Columns{ { count - 3, count - 2, count - 1 } };
    }
    return found && this->AreBytes(*found) ? found : std::nullopt;
  }

  void AddColors(vtkPolyData* data, const Columns& columns) const
  {
    vtkNew<vtkUnsignedCharArray> colors;
    colors->SetName("RGB");
    colors->SetNumberOfComponents(3);
    for (std::size_t i = 0; i < this->Count(); i++)
    {
      for (const std::size_t c : columns)
      {
        colors->InsertNextValue(static_cast<unsigned char>(this->At(i, c)));
      }
    }
    data->GetPointData()->AddArray(colors);
  }

  void AddArray(vtkPolyData* data, std::size_t c) const
  {
    vtkNew<vtkDoubleArray> array;
    array->SetName(this->Names[c].c_str());
    for (std::size_t i = 0; i < this->Count(); i++)
    {
      array->InsertNextValue(this->At(i, c));
    }
    data->GetPointData()->AddArray(array);
  }

  bool HasNames = false;
  std::vector<std::string> Names; // one a column
  std::vector<double> Values;     // row by row
};
}
}

vtkSmartPointer<vtkPolyData> ReadCloud(const std::string& path)
{
  cloud::Table table;
  table.Read(path);
  return table.MakeData();
}
}
