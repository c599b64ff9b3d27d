// SPDX-License-Identifier: BSD-3-Clause
#include "Shaders/ShaderArrays.h"

#include "Shaders/ShaderBuilder.h"

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
void FlattenArrays(const stock::Traits& traits, std::string& vertex, std::string& fragment)
{
  stock::Span found = stock::Look(vertex, stock::Edit::OutputArray, traits.If(traits.Clips));
  for (int i = 0; found.Number >= 0; i++)
  {
    const std::string& name = found.Groups[0];
    const std::string& size = found.Groups[1];
    const std::string declaration = "float " + name + "[" + size + "];\n";
    const PackedArray p = PackArray(name, std::stoi(size), i);
    stock::Replace(
      fragment, stock::Edit::InputArray, p.Inputs + declaration, traits.If(true), name);
    vertex.replace(found.At, found.Length, p.Outputs + declaration);
    wfv::ShaderBuilder::WrapMain(vertex, "", p.Pack);
    wfv::ShaderBuilder::WrapMain(fragment, p.Unpack, "");
    found = stock::Find(vertex, stock::Edit::OutputArray);
  }
}
}
