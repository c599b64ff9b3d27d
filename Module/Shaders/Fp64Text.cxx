// SPDX-License-Identifier: BSD-3-Clause
#include "Shaders/Fp64Text.h"

#include "WideFoVGlsl.h"

#include <map>
#include <regex>
#include <utility>

namespace wfv
{
namespace shader
{
std::string ToFp64(const std::string& glsl)
{
  static const std::pair<std::regex, const char*> rules[] = {
    { std::regex(R"(//(?! WideFoV:)[^\n]*)"), "" }, // but the names of files (NameText.cmake)
    { std::regex(R"(\bfloat\b)"), "double" },
    { std::regex(R"(\bvec([234])\b)"), "dvec$1" },
    { std::regex(R"(\bwfv(?!Fp64)([A-Z]))"), "wfvFp64$1" },
    { std::regex(R"(\bWfv([A-Z]))"), "WfvFp64$1" },
    { std::regex(R"(\bWFV_(?!FN\b|TABLES\b|TILTED\b|LENSED\b|NEWTON_STEPS\b))"), "WFV_FP64_" },
    { std::regex(R"((\b\d+(\.\d*([eE][-+]?\d+)?|[eE][-+]?\d+)))"), "$1lf" },
  };
  std::string fp64 = glsl;
  for (const auto& rule : rules)
  {
    fp64 = std::regex_replace(fp64, rule.first, rule.second);
  }
  return fp64;
}

const std::string& Fp64Source(const Projection& projection)
{
  static std::map<std::string, std::string> made;
  std::string& source = made[projection.Name];
  if (source.empty())
  {
    const bool sampled = projection.Axis == Family::Sampled;
    source = std::string("#ifdef GL_ARB_gpu_shader_fp64\n") + fp64_math_glsl +
      ToFp64(CommonGlsl()) + (sampled ? fp64_directions_glsl : "") + ToFp64(projection.Glsl) +
      "#endif\n";
  }
  return source;
}
}
}
