// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWideFoVShaderArrays.h"

#include "vtkWideFoVShaderBuilder.h"

#include <regex>

namespace
{
// One array of floats between the stages as vectors of four.
struct PackedArray
{
  std::string Outputs;
  std::string Inputs;
  std::string Pack;
  std::string Unpack;
};

PackedArray PackArray(const std::string& name, int count, int number)
{
  PackedArray p;
  for (int first = 0; first < count; first += 4)
  {
    const std::string vector =
      "wfvArray" + std::to_string(number) + "_" + std::to_string(first / 4) + "VSOutput";
    p.Outputs += "out vec4 " + vector + ";\n";
    p.Inputs += "in vec4 " + vector + ";\n";
    p.Pack += "  " + vector + " = vec4(";
    for (int k = 0; k < 4; k++)
    {
      const std::string at = name + "[" + std::to_string(first + k) + "]";
      p.Pack += (k ? ", " : "") + (first + k < count ? at : std::string("0.0"));
      p.Unpack +=
        first + k < count ? "  " + at + " = " + vector + "[" + std::to_string(k) + "];\n" : "";
    }
    p.Pack += ");\n";
  }
  return p;
}

}

namespace wfv
{
void FlattenArrays(std::string& vertex, std::string& fragment)
{
  static const std::regex array(R"(\bout\s+float\s+(\w+)\s*\[\s*(\d+)\s*\]\s*;)");
  std::smatch m;
  for (int i = 0; std::regex_search(vertex, m, array); i++)
  {
    const std::string name = m[1];
    const std::string declaration = "float " + name + "[" + m[2].str() + "];\n";
    const PackedArray p = PackArray(name, std::stoi(m[2]), i);
    const std::regex input(R"(\bin\s+float\s+)" + name + R"(\s*\[\s*\d+\s*\]\s*;)");
    fragment = std::regex_replace(fragment, input, p.Inputs + declaration);
    vertex.replace(m.position(0), m.length(0), p.Outputs + declaration);
    vtkWideFoVShaderBuilder::WrapMain(vertex, "", p.Pack);
    vtkWideFoVShaderBuilder::WrapMain(fragment, p.Unpack, "");
  }
}
}
