// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWideFoVVaryings.h"

#include <algorithm>
#include <regex>

namespace wfv
{
std::string Varying::Input() const
{
  return (this->Flat ? "flat in " : "in ") + this->Type + " " + this->Name + "[];\n";
}

std::string Varying::Declaration(const std::string& name) const
{
  return this->Type + " " + name + ";\n";
}

int Varying::Components() const
{
  const char last = this->Type.back();
  const int size = last >= '2' && last <= '4' ? last - '0' : 1;
  return this->Type.compare(0, 3, "mat") == 0 ? size * size : size;
}

std::vector<Varying> FindVaryings(const std::string& vertex)
{
  static const std::regex output(
    R"((flat\s+|smooth\s+|noperspective\s+)?\bout\s+(\w+)\s+(\w+)\s*;)");
  std::vector<Varying> result;
  for (std::sregex_iterator i(vertex.begin(), vertex.end(), output), end; i != end; ++i)
  {
    result.push_back({ (*i)[1].str().compare(0, 4, "flat") == 0, (*i)[2], (*i)[3] });
  }
  return result;
}

void RemoveInputs(std::string& fragment, const std::vector<Varying>& varyings)
{
  for (const Varying& v : varyings)
  {
    const std::regex input(
      R"((flat\s+|smooth\s+|noperspective\s+)?\bin\s+)" + v.Type + R"(\s+)" + v.Name + R"(\s*;)");
    fragment = std::regex_replace(fragment, input, "");
  }
}

std::string CornerName(size_t varying, int corner)
{
  return "wfvCorner" + std::to_string(varying) + "_" + std::to_string(corner);
}

std::string CornerOutputs(const std::vector<Varying>& varyings, int corners)
{
  std::string declarations;
  std::string body;
  for (size_t i = 0; i < varyings.size(); i++)
  {
    const Varying& v = varyings[i];
    declarations += v.Input();
    for (int c = v.Flat ? corners - 1 : 0; c < corners; c++)
    {
      declarations += "flat out " + v.Declaration(CornerName(i, c));
      body += "  " + CornerName(i, c) + " = " + v.Name + "[" + std::to_string(c) + "];\n";
    }
  }
  return declarations + "void wfvWriteCorners()\n{\n" + body + "}\n";
}

std::string CornerInputs(
  const std::vector<Varying>& varyings, const std::vector<std::string>& weights)
{
  const int corners = static_cast<int>(weights.size());
  std::string declarations;
  std::string body;
  for (size_t i = 0; i < varyings.size(); i++)
  {
    const Varying& v = varyings[i];
    declarations += v.Declaration(v.Name);
    std::string sum;
    for (int c = v.Flat ? corners - 1 : 0; c < corners; c++)
    {
      declarations += "flat in " + v.Declaration(CornerName(i, c));
      sum += (sum.empty() ? "" : " + ") + (v.Flat ? "" : weights[c] + " * ") + CornerName(i, c);
    }
    body += "  " + v.Name + " = " + sum + ";\n";
  }
  return declarations + "void wfvInterpolate()\n{\n" + body + "}\n";
}

int CornerComponents(const std::vector<Varying>& varyings, int corners)
{
  int count = 0;
  for (const Varying& v : varyings)
  {
    count += v.Components() * (v.Flat ? 1 : corners);
  }
  return count;
}

void ReplaceAll(std::string& text, const std::string& from, const std::string& to)
{
  for (size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
  {
    text.replace(at, from.size(), to);
  }
}
}
