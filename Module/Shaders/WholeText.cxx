// SPDX-License-Identifier: BSD-3-Clause
#include "Shaders/WholeText.h"

#include "WideFoVGlsl.h"

#include <map>
#include <regex>
#include <utility>

namespace wfv
{
namespace shader
{
std::string ToWhole(const std::string& glsl)
{
  static const std::pair<std::regex, const char*> rules[] = {
    { std::regex(R"(//(?! WideFoV:)[^\n]*)"), "" }, // but the names of files (NameText.cmake)
    { std::regex(R"(\bfloat\b)"), "double" },
    { std::regex(R"(\bvec([234])\b)"), "dvec$1" },
    { std::regex(R"(\bwfv(?!Whole)([A-Z]))"), "wfvWhole$1" },
    { std::regex(R"(\bWfv([A-Z]))"), "WfvWhole$1" },
    { std::regex(R"(\bWFV_(?!FN\b|TABLES\b|TILTED\b|LENSED\b|NEWTON_STEPS\b))"), "WFV_WHOLE_" },
    { std::regex(R"((\b\d+(\.\d*([eE][-+]?\d+)?|[eE][-+]?\d+)))"), "$1lf" },
  };
  std::string whole = glsl;
  for (const auto& rule : rules)
  {
    whole = std::regex_replace(whole, rule.first, rule.second);
  }
  return whole;
}

const std::string& WholeSource(const Projection& projection)
{
  static std::map<std::string, std::string> made;
  std::string& source = made[projection.Name];
  if (source.empty())
  {
    const bool sampled = projection.Axis == Family::Sampled;
    source = std::string("#ifdef GL_ARB_gpu_shader_fp64\n") + whole_math_glsl +
      ToWhole(CommonGlsl()) + (sampled ? whole_directions_glsl : "") + ToWhole(projection.Glsl) +
      "#endif\n";
  }
  return source;
}
}
}
