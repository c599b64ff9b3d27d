// SPDX-License-Identifier: BSD-3-Clause
// The shader builder is text in, text out: tested on text.
#include "Shaders/ShaderBuilder.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>

namespace
{
using Builder = wfv::ShaderBuilder;

const char* const Vertex = "//VTK::System::Dec\n"
                           "in vec4 vertexMC;\n"
                           "out vec3 normalVCVSOutput;\n"
                           "out float clipDistancesVSOutput[6];\n"
                           "flat out int vertexIDVSOutput;\n"
                           "void main()\n{\n  gl_Position = vertexMC;\n}\n";

const char* const Fragment = "//VTK::System::Dec\n"
                             "in vec3 normalVCVSOutput;\n"
                             "in float clipDistancesVSOutput[6];\n"
                             "flat in int vertexIDVSOutput;\n"
                             "void main()\n{\n"
                             "  // Set gl_FragDepth here (gl_FragCoord.z by default)\n"
                             "  float z = gl_FragCoord.z;\n}\n";

struct Sources
{
  std::string VertexStage = Vertex;
  std::string GeometryStage;
  std::string FragmentStage = Fragment;
};

Sources Build(const char* projection, Builder::Variant variant, Builder::Primitive kind,
  Builder::Request request = Builder::Request())
{
  request.View.Projection = wfv::FindProjection(projection);
  request.Stage = variant;
  request.Kind = kind;
  Sources s;
  Builder::Prepare(request, s.GeometryStage, s.FragmentStage);
  Builder::Finish(request, s.VertexStage, s.GeometryStage, s.FragmentStage);
  return s;
}

bool Has(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}
}

TEST(ShaderBuilder, PlainProjectsInTheVertexStageAlone)
{
  const Sources s = Build("hammer", Builder::Variant::Projected, Builder::Primitive::Triangles);
  EXPECT_TRUE(Has(s.VertexStage, "wfvProjectBeside(gl_Position.xyz)"));
  EXPECT_TRUE(s.GeometryStage.empty());
  // the place of a fragment has its depth
  EXPECT_TRUE(Has(s.FragmentStage, "wfvPrepareDepth(wfvPlaceVSOutput.xyz);"));
  EXPECT_FALSE(Has(s.FragmentStage, "float z = gl_FragCoord.z"));
}

TEST(ShaderBuilder, PreClipCarriesEveryOutputByThreeCorners)
{
  const Sources s =
    Build("equirectangular", Builder::Variant::PreClip, Builder::Primitive::Triangles);
  EXPECT_FALSE(Has(s.VertexStage, "wfvProject"));
  EXPECT_TRUE(Has(s.GeometryStage, "in vec3 normalVCVSOutput[];"));
  // GLSL 1.50 has no arrays of arrays
  EXPECT_TRUE(Has(s.VertexStage,
    "wfvArray0_1VSOutput = vec4(clipDistancesVSOutput[4], clipDistancesVSOutput[5], 0.0, 0.0);"));
  EXPECT_TRUE(Has(s.GeometryStage, "in vec4 wfvArray0_1VSOutput[];"));
  EXPECT_TRUE(Has(s.FragmentStage, "normalVCVSOutput = wfvB.x * "));
  EXPECT_TRUE(Has(s.FragmentStage, "clipDistancesVSOutput[5] = wfvArray0_1VSOutput[1];"));
  EXPECT_FALSE(Has(s.FragmentStage, "in vec3 normalVCVSOutput;"));
  // whole numbers are not mixed
  EXPECT_TRUE(Has(s.FragmentStage, "vertexIDVSOutput = wfvCorner3_2;"));
  EXPECT_FALSE(Has(s.FragmentStage, "float z = gl_FragCoord.z"));
  EXPECT_TRUE(Has(s.FragmentStage, "gl_FragDepth = wfvDepth + wfvPolygonOffsetAt(wfvDepth);"));
}

// The coordinates of the buffer go from the vertex to the geometry stage, and no farther.
TEST(ShaderBuilder, TrianglesKeepAllDigitsOfTheirCorners)
{
  Builder::Request request;
  request.View.Projection = wfv::FindProjection("hammer");
  for (auto variant : { Builder::Variant::Exact, Builder::Variant::Projected })
  {
    request.Stage = variant;
    Sources s;
    s.VertexStage = "//VTK::System::Dec\nvoid main()\n{\n"
                    "  gl_Position = MCDCMatrix * vertexMC;\n}\n";
    Builder::Finish(request, s.VertexStage, s.GeometryStage, s.FragmentStage);
    EXPECT_TRUE(Has(s.VertexStage, "gl_Position = wfvFromEyeOf(MCDCMatrix, vertexMC);"));
    const bool model = variant == Builder::Variant::Exact;
    EXPECT_EQ(Has(s.VertexStage, "#define WFV_MODEL 1"), model);
    EXPECT_EQ(Has(s.GeometryStage, "#define WFV_MODEL 1\n#define WFV_TO_VIEW MCDCMatrix\n"), model);
    // extensions come before anything else
    const std::string head = "//VTK::System::Dec\n#extension GL_ARB_gpu_shader_fp64 : enable\n";
    EXPECT_EQ(s.GeometryStage.find(head) == 0, variant != Builder::Variant::Projected);
    EXPECT_FALSE(Has(s.FragmentStage, "wfvModel"));
  }
}

TEST(ShaderBuilder, ATriangleKnowsItsFlatNormal)
{
  const std::string stock = "//VTK::System::Dec\nvoid main()\n{\n"
                            "  vec3 normalVCVSOutput = normalize(cross(fdx,fdy));\n}\n";
  Builder::Request request;
  request.View.Projection = wfv::FindProjection("hammer");
  for (auto variant : { Builder::Variant::PreClip, Builder::Variant::Projected })
  {
    request.Stage = variant;
    Sources s;
    s.FragmentStage = stock;
    Builder::Finish(request, s.VertexStage, s.GeometryStage, s.FragmentStage);
    EXPECT_EQ(Has(s.FragmentStage, "vec3 normalVCVSOutput = wfvFlatNormal();"),
      variant == Builder::Variant::PreClip);
  }
}

TEST(ShaderBuilder, LinesMixTheirTwoEnds)
{
  const Sources s = Build("equirectangular", Builder::Variant::PreClip, Builder::Primitive::Lines);
  EXPECT_TRUE(Has(s.GeometryStage, "(1.0 - t) * normalVCVSOutput[0] + t * normalVCVSOutput[1]"));
  EXPECT_TRUE(Has(s.GeometryStage, "layout(lines) in"));
}

TEST(ShaderBuilder, ExactLinesAreWeighedByTheirNearestPoint)
{
  const Sources s = Build("equirectangular", Builder::Variant::Exact, Builder::Primitive::Lines);
  EXPECT_TRUE(Has(s.GeometryStage, "wfvCorner0_1 = normalVCVSOutput[1];"));
  EXPECT_TRUE(Has(s.FragmentStage,
    "normalVCVSOutput = (1.0 - wfvAlong) * wfvCorner0_0 + wfvAlong * wfvCorner0_1;"));
  EXPECT_TRUE(Has(s.FragmentStage, "wfvDepth = wfvDepthOf(rho, wfvView);"));
  EXPECT_TRUE(Has(s.FragmentStage, "gl_FragDepth = wfvDepth;"));
  // OpenGL 3.2: 1,024 components from one run of the stage; position, primitive number, 15
  // of its own, and two copies of 3 + 4 + 4 and one of 1
  EXPECT_TRUE(Has(s.GeometryStage, "#define WFV_LINE_VERTICES 20\n"));
  const Sources cube =
    Build("equi-angular-cubemap", Builder::Variant::Exact, Builder::Primitive::Lines);
  EXPECT_TRUE(Has(cube.GeometryStage, "#define WFV_LINE_VERTICES 20\n"));
  EXPECT_TRUE(Has(cube.GeometryStage, "wfvEmitOnFaces(dots);"));
  // a chord is all that a straight line needs
  const Sources flat = Build("perspective", Builder::Variant::Exact, Builder::Primitive::Lines);
  EXPECT_TRUE(Has(flat.GeometryStage, "wfvWriteMix(float t)"));
}

TEST(ShaderBuilder, OnlyWidePointsNeedAGeometryStage)
{
  const Sources s = Build("equirectangular", Builder::Variant::PreClip, Builder::Primitive::Points);
  EXPECT_TRUE(s.GeometryStage.empty());
  EXPECT_TRUE(Has(s.VertexStage, "wfvProjectVertex"));
  Builder::Request request;
  request.Points.Wide = true;
  const Sources wide =
    Build("equirectangular", Builder::Variant::PreClip, Builder::Primitive::Points, request);
  EXPECT_TRUE(Has(wide.GeometryStage, "layout(points) in;"));
  EXPECT_FALSE(Has(wide.VertexStage, "wfvProject"));
  EXPECT_TRUE(Has(wide.FragmentStage, "normalVCVSOutput = 1.0 * wfvCorner0_0;"));
  EXPECT_TRUE(Has(wide.FragmentStage, "vertexIDVSOutput = wfvCorner3_0;"));
  // what meets no discontinuity needs none either
  const Sources plain =
    Build("equirectangular", Builder::Variant::Projected, Builder::Primitive::Points, request);
  EXPECT_TRUE(plain.GeometryStage.empty());
}

TEST(ShaderBuilder, RoundMapsEndAtTheirRim)
{
  const Sources s =
    Build("azimuthal-equidistant", Builder::Variant::Projected, Builder::Primitive::Triangles);
  EXPECT_TRUE(Has(s.FragmentStage, "if (wfvOutsideDomain()) { discard; }"));
}

// As VTK 9.1 writes it, and 9.2 and later.
TEST(ShaderBuilder, HeadlightsShineFromTheEye)
{
  const std::pair<const char*, const char*> cosines[] = {
    { "max(0.0,normalVCVSOutput.z)", "max(0.0, dot(normalVCVSOutput, -wfvFromEye))" },
    { "max(0.000001, normalVCVSOutput.z)", "max(0.000001, dot(normalVCVSOutput, -wfvFromEye))" }
  };
  for (const auto& [stock, ours] : cosines)
  {
    Builder::Request request;
    request.View.Projection = wfv::FindProjection("hammer");
    std::string vertex = Vertex;
    std::string geometry;
    std::string fragment = std::string("//VTK::System::Dec\n"
                                       "uniform vec3 lightDirectionVC0;\n"
                                       "void main()\n{\n"
                                       "vec4 vertexVC = vertexVCVSOutput;\n"
                                       "  float df = ") +
      stock +
      ";\n"
      "  sf = sign(df)*pow(max(1e-5, dot( reflect(lightDirectionVC12, n), v)), specularPower);\n"
      "  df = dot(normalVCVSOutput, -lightDirectionVC0);\n}\n";
    Builder::Finish(request, vertex, geometry, fragment);
    EXPECT_TRUE(Has(fragment, std::string("float df = ") + ours + ";")) << fragment;
    EXPECT_TRUE(Has(fragment, "uniform vec3 lightDirectionVC0;"));
    EXPECT_TRUE(Has(fragment, "-wfvLightDirection(0, lightDirectionVC0)"));
    EXPECT_TRUE(Has(fragment, "reflect(wfvLightDirection(12, lightDirectionVC12), n)"));
    EXPECT_TRUE(wfv::stock::Missing(fragment).empty());
  }
}

// As VTK 9.1 writes it, and 9.3 and later.
TEST(ShaderBuilder, ALineKnowsItsNormal)
{
  const char* const stocks[] = {
    "  if (abs(fdx.x) > 0.0)\n"
    "    { normalVCVSOutput = normalize(cross(vec3(fdx.y, -fdx.x, 0.0), fdx)); }\n"
    "  else { normalVCVSOutput = normalize(cross(vec3(fdy.y, -fdy.x, 0.0), fdy));}\n",
    "  vec3 normalVCVSOutput = normalize(cross(vec3(lineVec.y, -lineVec.x, 0.0), lineVec));\n"
  };
  for (const char* const stock : stocks)
  {
    Builder::Request request;
    request.View.Projection = wfv::FindProjection("hammer");
    request.Kind = Builder::Primitive::Lines;
    request.Stage = Builder::Variant::Exact;
    std::string vertex = std::string("out vec4 vertexVCVSOutput;\n") + Vertex;
    std::string geometry;
    std::string fragment = std::string("//VTK::System::Dec\nvoid main()\n{\n") + stock + "}\n";
    Builder::Finish(request, vertex, geometry, fragment);
    EXPECT_FALSE(Has(fragment, "normalize(cross(vec3(")) << fragment;
    EXPECT_TRUE(Has(fragment, "normalVCVSOutput = wfvLineNormal(wfvCorner0_1.xyz - "));
  }
}

// As VTK 9.1 writes it, and 9.4 and later, whose vertex stage works out ellipses.
TEST(ShaderBuilder, ASplatHasARadius)
{
  const std::string head = "//VTK::System::Dec\n"
                           "in vec4 vertexMC;\n";
  const std::string older = head +
    "in float radiusMC;\nout float radiusVCVSOutput;\nvoid main()\n{\n"
    "  radiusVCVSOutput = radiusMC;\n  gl_Position = MCVCMatrix * vertexMC;\n}\n";
  const std::string newer = head +
    "uniform float scaleFactor;\n"
    "in float radiusMC;\nout mat2 transformVCVSOutput;\n"
    "void main()\n{\n  vec4 posVC = MCVCMatrix * vertexMC;\n"
    "float radius = scaleFactor * radiusMC;\n  gl_Position = VCDCMatrix * posVC;\n}\n";
  Builder::Request request;
  request.View.Projection = wfv::FindProjection("hammer");
  request.Kind = Builder::Primitive::Splats;
  request.Stock.Known = true;
  Sources s;
  s.VertexStage = older;
  s.FragmentStage = "//VTK::System::Dec\n//VTK::Depth::Impl\nvoid main()\n{\n}\n";
  Sources t = s;
  t.VertexStage = newer;
  Builder::Finish(request, s.VertexStage, s.GeometryStage, s.FragmentStage);
  Builder::Finish(request, t.VertexStage, t.GeometryStage, t.FragmentStage);
  EXPECT_TRUE(Has(s.FragmentStage, "#define WFV_SPLAT_SCALE triangleScale\n"));
  EXPECT_TRUE(Has(t.FragmentStage, "#define WFV_SPLAT_SCALE boundScale\n"));
  EXPECT_TRUE(Has(t.VertexStage, "radiusVCVSOutput = boundScale * radius;"));
  for (const Sources& sources : { s, t })
  {
    EXPECT_TRUE(Has(sources.VertexStage, "out float radiusVCVSOutput;"));
    EXPECT_TRUE(Has(sources.GeometryStage, "in float radiusVCVSOutput[];"));
    EXPECT_TRUE(wfv::stock::Missing(sources.VertexStage + sources.FragmentStage).empty());
  }
}

TEST(ShaderBuilder, SteadyLightsAreConstants)
{
  const std::string lights = "lightColor0 vec3(1, 0.5, 0)\nlightDirectionVC1 vec3(0, 0, -1)\n";
  Builder::Request request;
  request.View.Projection = wfv::FindProjection("hammer");
  request.Lights.Constants = &lights;
  std::string vertex = Vertex;
  std::string geometry;
  std::string fragment = "//VTK::System::Dec\n"
                         "uniform vec3 lightColor0; //intensity weighted color\n"
                         "uniform vec3 lightColor1; //intensity weighted color\n"
                         "uniform vec3 lightDirectionVC1; // normalized\n"
                         "void main()\n{\n"
                         "vec4 vertexVC = vertexVCVSOutput;\n}\n";
  Builder::Finish(request, vertex, geometry, fragment);
  EXPECT_TRUE(Has(fragment, "const vec3 lightColor0 = vec3(1, 0.5, 0);"));
  EXPECT_TRUE(Has(fragment, "uniform vec3 lightColor1;"));
  EXPECT_TRUE(Has(fragment, "const vec3 lightDirectionVC1 = vec3(0, 0, -1);"));
}

TEST(ShaderBuilder, WrappingNests)
{
  std::string source = "void main()\n{\n}\n";
  Builder::WrapMain(source, "  a();\n", "");
  Builder::WrapMain(source, "", "  b();\n");
  EXPECT_TRUE(Has(source, "void wfvStockMain0()"));
  EXPECT_TRUE(Has(source, "void wfvStockMain1()"));
  EXPECT_LT(source.find("wfvStockMain0();"), source.rfind("wfvStockMain1();"));
  EXPECT_EQ(source.find("void main()"), source.rfind("void main()"));
}

TEST(ShaderBuilder, ADepthMappingIsWrittenInTheFragmentStage)
{
  Builder::Request request;
  request.View.DepthMapping = wfv::WFV_DEPTH_LOGARITHMIC;
  for (auto kind : { Builder::Primitive::Triangles, Builder::Primitive::Points })
  {
    const Sources s = Build("hammer", Builder::Variant::Projected, kind, request);
    EXPECT_TRUE(Has(s.VertexStage, "wfvPlaceVSOutput = gl_Position.xyz;"));
    const bool triangles = kind == Builder::Primitive::Triangles;
    const std::size_t projected =
      s.VertexStage.find(triangles ? "wfvProjectBeside(gl" : "wfvProjectVertex(gl");
    EXPECT_LT(s.VertexStage.find("wfvPlaceVSOutput = "), projected);
    EXPECT_LT(projected, std::string::npos);
    EXPECT_TRUE(Has(s.FragmentStage, "gl_FragDepth = wfvDepth"));
    EXPECT_FALSE(Has(s.FragmentStage, "float z = gl_FragCoord.z"));
  }
  const Sources lines =
    Build("hammer", Builder::Variant::PreClip, Builder::Primitive::Lines, request);
  EXPECT_TRUE(Has(lines.GeometryStage, "wfvPlaceGSOutput = place.seen"));
  EXPECT_TRUE(Has(lines.FragmentStage, "gl_FragDepth = wfvDepth;"));
  // covered triangles have their depth from the ray already
  const Sources triangles =
    Build("hammer", Builder::Variant::PreClip, Builder::Primitive::Triangles, request);
  EXPECT_FALSE(Has(triangles.VertexStage, "wfvPlace"));
}

TEST(ShaderBuilder, ADebugViewReplacesTheColourNotTheLight)
{
  Builder::Request request;
  request.DebugView = true;
  request.View.Projection = wfv::FindProjection("hammer");
  const std::string stock = "//VTK::System::Dec\nvoid main()\n{\n  //VTK::Color::Impl\n"
                            "  //VTK::Light::Impl\n  //VTK::TCoord::Impl\n}\n";
  for (auto variant : { Builder::Variant::Projected, Builder::Variant::PreClip })
  {
    request.Stage = variant;
    std::string vertex = Vertex;
    std::string geometry;
    std::string fragment = stock;
    Builder::Prepare(request, geometry, fragment);
    EXPECT_LT(fragment.find("//VTK::Color::Impl"), fragment.find("wfvDebugColor()"));
    EXPECT_LT(fragment.find("wfvDebugColor()"), fragment.find("//VTK::Light::Impl"));
    EXPECT_FALSE(Has(fragment, "//VTK::TCoord::Impl"));
    Builder::Finish(request, vertex, geometry, fragment);
    EXPECT_TRUE(Has(fragment, "vec3 wfvDebugColor()"));
    EXPECT_EQ(Has(geometry, "int wfvCoverKind("), variant == Builder::Variant::PreClip);
  }
}

TEST(ShaderBuilder, QuadricsMeetTheRayInAnyVariant)
{
  for (auto variant : { Builder::Variant::Projected, Builder::Variant::PreClip })
  {
    const Sources s = Build("hammer", variant, Builder::Primitive::Tubes);
    EXPECT_TRUE(Has(s.GeometryStage, "layout(lines) in;"));
    EXPECT_TRUE(Has(s.GeometryStage, "#define WFV_ANGULAR 1"));
    EXPECT_TRUE(Has(s.FragmentStage, "wfvPrepare(0);"));
    // interpolated along the segment; what is flat, from its last vertex
    EXPECT_TRUE(Has(s.FragmentStage, "normalVCVSOutput = mix("));
    EXPECT_TRUE(Has(s.FragmentStage, "vertexIDVSOutput = wfvCorner"));
    EXPECT_FALSE(Has(s.FragmentStage, "in vec3 normalVCVSOutput"));
  }
}

TEST(ShaderBuilder, ThePiecesOfASpanFitWhatAGeometryStageMayEmit)
{
  const Sources few = Build("hammer", Builder::Variant::Projected, Builder::Primitive::Cylinders);
  EXPECT_TRUE(Has(few.GeometryStage, "#define WFV_PIECES 4"));
  Builder::Request request;
  request.View.Projection = wfv::FindProjection("hammer");
  request.Kind = Builder::Primitive::Tubes;
  Sources many;
  for (int i = 0; i < 8; i++)
  {
    const std::string name = "a" + std::to_string(i) + "VSOutput";
    many.VertexStage.insert(0, "out vec4 " + name + ";\n");
  }
  Builder::Finish(request, many.VertexStage, many.GeometryStage, many.FragmentStage);
  EXPECT_TRUE(Has(many.GeometryStage, "#define WFV_PIECES 1\n"));
  EXPECT_TRUE(Has(many.GeometryStage, "#define WFV_SPAN_VERTICES 8\n"));
}

TEST(ShaderBuilder, AFamilyWithoutAnglesIsCoveredByTheWholeWindow)
{
  wfv::Projection other = *wfv::FindProjection("hammer");
  other.Axis = wfv::Family::Planar;
  Builder::Request request;
  request.View.Projection = &other;
  request.Kind = Builder::Primitive::Spheres;
  Sources s;
  Builder::Finish(request, s.VertexStage, s.GeometryStage, s.FragmentStage);
  EXPECT_TRUE(Has(s.GeometryStage, "#define WFV_ANGULAR 0"));
}
