// SPDX-License-Identifier: BSD-3-Clause
#include "Shaders/aov/DataShaders.h"

#include "Shaders/ShaderBuilder.h"
#include "WideFoVGlsl.h"

namespace wfv
{
namespace data
{
using stock::Edit;

void Prepare(const stock::Traits& traits, bool wide, std::string& geometry, std::string& fragment)
{
  // stock geometry stages (surface edges, wide lines) would drop our output; without
  // them the surface is drawn without its edges
  if (wide || !traits.Impostors)
  {
    geometry.clear();
  }
  if (!wide)
  {
    stock::Replace(fragment, Edit::EdgesDeclaration, "", traits.If(true));
    stock::Replace(fragment, Edit::EdgesPlace, "", traits.If(true));
  }
}

void Finish(const stock::Traits& traits, bool wide, std::string& vertex, std::string& geometry,
  std::string& fragment)
{
  if (traits.Impostors && !wide)
  {
    wfv::ShaderBuilder::Declare(geometry, data_geometry_glsl);
  }
  else
  {
    wfv::ShaderBuilder::WrapMain(vertex, "", "  wfvKeepPosition();\n");
    wfv::ShaderBuilder::Declare(vertex, data_vertex_glsl);
  }
  wfv::ShaderBuilder::Declare(
    fragment, (wide ? "" : std::string(data_perspective_glsl)) + data_fragment_glsl);
  const bool lit = traits.Light != stock::Lit::No && (traits.Normals || !traits.Wireframe);
  const bool has = stock::Look(fragment, Edit::DataNormal, traits.If(lit)).Number >= 0;
  const std::string normal = has ? "wfvDataNormal(normalVCVSOutput)" : "wfvFlatNormal()";
  // spheres and cylinders work their surface out; elsewhere it is what is interpolated
  const bool sphere = fragment.find("centerVCVSOutput") != std::string::npos;
  const std::string position = sphere ? "vertexVC.xyz" : "WFV_PLACE";
  stock::Replace(fragment, Edit::DataPlace,
    "  gl_FragData[1] = wfvData(" + position +
      ", gl_PrimitiveID + PrimitiveIDOffset);\n"
      "  gl_FragData[2] = vec4(" +
      normal + ", 1.0);\n  $&\n",
    traits.If(true));
}
}
}
