// SPDX-License-Identifier: BSD-3-Clause
#include "Shaders/quadrics/QuadricShaders.h"

#include "Compat/StockEdits.h"
#include "Shaders/ShaderArrays.h"
#include "Shaders/ShaderText.h"
#include "WideFoVGlsl.h"

#include <algorithm>

namespace wfv
{
namespace quadric
{
using namespace shader;
using stock::Edit;

namespace
{
// Of a vertex of the cover, beside the stock shader's own: position, two spheres, share,
// primitive.
constexpr int QuadricComponents = 4 + 4 + 4 + 2 + 1;

// Pieces of a long span: more would spare few pixels.
constexpr int MostPieces = 4;

// Inputs that the stock fragment stage takes from its own geometry stage, or from the
// vertices where the surface itself is meant: the fragment stage sets them or needs none.
const std::vector<Varying>& OwnInputs()
{
  static const std::vector<Varying> own{ { false, "vec4", "vertexVCVSOutput" },
    { false, "vec3", "centerVCVSOutput" }, { false, "float", "radiusVCVSOutput" },
    { false, "vec3", "orientVCVSOutput" }, { false, "float", "lengthVCVSOutput" },
    { false, "vec2", "offsetVCVSOutput" } };
  return own;
}

// How the inputs that stand for the surface follow from what the ray meets.
std::string SurfaceValue(const Request& r, const std::string& name)
{
  if (name == "vertexVCVSOutput")
  {
    return "vec4(wfvSurface, 1.0)";
  }
  if (name == "offsetVCVSOutput")
  {
    return r.Kind == Primitive::Splats ? "wfvSplatOffset()" : "";
  }
  return name == "wfvPositionVSOutput" ? "wfvSurface" : "";
}

bool HasName(const std::vector<Varying>& varyings, const std::string& name)
{
  const auto same = [&name](const Varying& v) { return v.Name == name; };
  return std::any_of(varyings.begin(), varyings.end(), same);
}

bool IsOwn(const Varying& v)
{
  return v.Name == "wfvPositionVSOutput" || v.Name == "transformVCVSOutput" ||
    HasName(OwnInputs(), v.Name);
}

bool IsSegment(const Request& r)
{
  return r.Kind == Primitive::Tubes;
}

// Which vertices of the primitive an output is copied from: both ends of a segment, but
// the last alone (as OpenGL has it) where it is not interpolated.
std::vector<int> Corners(const Request& r, const Varying& v)
{
  return !IsSegment(r) ? std::vector<int>{ 0 }
                       : (v.Flat ? std::vector<int>{ 1 } : std::vector<int>{ 0, 1 });
}

std::string CornerOutputs(const Request& r, const std::vector<Varying>& varyings)
{
  std::string declarations;
  std::string body;
  for (size_t i = 0; i < varyings.size(); i++)
  {
    const Varying& v = varyings[i];
    declarations += v.Input();
    for (int c : IsOwn(v) ? std::vector<int>() : Corners(r, v))
    {
      declarations += "flat out " + v.Declaration(Corner(i, c));
      body += "  " + Corner(i, c) + " = " + v.Name + "[" + std::to_string(c) + "];\n";
    }
  }
  return declarations + "void wfvWriteCorners()\n{\n" + body + "}\n";
}

// The value of an input at wfvAlong.
std::string CornerValue(const Request& r, const Varying& v, size_t i)
{
  const std::vector<int> corners = Corners(r, v);
  return corners.size() == 2 ? "mix(" + Corner(i, 0) + ", " + Corner(i, 1) + ", wfvAlong)"
                             : Corner(i, corners[0]);
}

std::string CornerInputs(const Request& r, const std::vector<Varying>& varyings)
{
  std::string declarations;
  std::string body;
  for (size_t i = 0; i < varyings.size(); i++)
  {
    const Varying& v = varyings[i];
    declarations += v.Declaration(v.Name);
    for (int c : IsOwn(v) ? std::vector<int>() : Corners(r, v))
    {
      declarations += "flat in " + v.Declaration(Corner(i, c));
    }
    const std::string value = IsOwn(v) ? SurfaceValue(r, v.Name) : CornerValue(r, v, i);
    body += value.empty() ? "" : "  " + v.Name + " = " + value + ";\n";
  }
  return declarations + "void wfvInterpolate()\n{\n" + body + "}\n";
}

// Rectangles of a span that the components of their vertices leave room for: two a
// piece, where it crosses the seam.
int CountPieces(const Request& r, const std::vector<Varying>& varyings)
{
  int components = QuadricComponents;
  for (const Varying& v : varyings)
  {
    const int size = v.Type.compare(0, 3, "vec") == 0 ? v.Type[3] - '0' : 1;
    components += IsOwn(v) ? 0 : size * static_cast<int>(Corners(r, v).size());
  }
  return std::max(1, std::min(MostPieces, MostComponents / components / 8));
}

// How a round cap of directions is covered.
std::string CapSource(const Projection& projection)
{
  switch (projection.Axis)
  {
    case Family::Meridian:
    case Family::Azimuthal:
      return cap_angles_glsl;
    case Family::Sampled:
      return cap_directions_glsl;
    default:
      return cap_window_glsl;
  }
}

std::string GeometrySource(const Request& r, const std::vector<Varying>& varyings)
{
  const int pieces = CountPieces(r, varyings);
  const bool pixels = r.Kind == Primitive::PointSpheres;
  const std::string head = "//VTK::System::Dec\n" + ViewSource(r) +
    Define("WFV_ANGULAR",
      r.View.Projection->Axis == Family::Meridian || r.View.Projection->Axis == Family::Azimuthal) +
    Define("WFV_PIECES", pieces) + Define("WFV_SPAN_VERTICES", 8 * pieces) +
    "#define WFV_SPHERE_RADIUS " +
    (pixels ? "wfvPixelRadius(centre)" : "radiusVCVSOutput[0] / wfvScale()") + "\n" +
    CornerOutputs(r, varyings) + quadric_cover_glsl + CapSource(*r.View.Projection);
  switch (r.Kind)
  {
    case Primitive::Tubes:
      return head + quadric_pixels_glsl + quadric_span_glsl + quadric_tubes_glsl;
    case Primitive::Cylinders:
      return head + quadric_span_glsl + quadric_cylinders_glsl;
    case Primitive::Splats:
      return head + quadric_splats_glsl;
    case Primitive::PointSpheres:
      return head + quadric_pixels_glsl + quadric_spheres_glsl;
    default:
      return head + quadric_spheres_glsl;
  }
}

// How the ray meets it.
std::string MeetSource(Primitive kind)
{
  switch (kind)
  {
    case Primitive::Tubes:
      return quadric_tube_glsl;
    case Primitive::Cylinders:
      return quadric_cylinder_glsl;
    case Primitive::Splats:
      return quadric_splat_glsl;
    default:
      return quadric_sphere_glsl;
  }
}

// What the geometry stage takes its shapes from, and of splats the name of the uniform that says
// how many of the gaussian's radii the disc has.
std::string LookForShape(const Request& r, std::string& vertex)
{
  if (r.Kind == Primitive::Spheres || r.Kind == Primitive::Cylinders)
  {
    stock::Look(vertex, Edit::SphereRadius, r.Stock.If(true));
    stock::Look(vertex, Edit::CylinderAxis, r.Stock.If(r.Kind == Primitive::Cylinders));
  }
  if (r.Kind != Primitive::Splats ||
    stock::Look(vertex, Edit::SplatRadius, r.Stock.If(true)).Number < 1)
  {
    return "triangleScale"; // which is in the radius
  }
  stock::Replace(vertex, Edit::SplatRadius, "$&\n  radiusVCVSOutput = boundScale * radius;");
  wfv::ShaderBuilder::Declare(vertex, "uniform float boundScale;\nout float radiusVCVSOutput;\n");
  return "boundScale";
}

// What main begins with.
std::string Before(const Request& r, std::string& fragment)
{
  // the stock sphere mapper draws translucent spheres twice, their backs first
  const std::string side = r.Kind == Primitive::Spheres
    ? "opacityUniform >= 1.0 ? 0 : (invertedDepth < 0.0 ? -1 : 1)"
    : "0";
  // of tubes and points, where the stock text adds it to a depth of its own
  const bool offset = (IsSegment(r) || r.Kind == Primitive::PointSpheres) &&
    stock::Look(fragment, Edit::DepthOffset, stock::Found::May).Number >= 0;
  return "  wfvPrepare(" + side + ");\n  gl_FragDepth = wfvDepth" +
    (offset ? " + wfvOffsetOfDepth(wfvDepth, cOffset / 65000.0)" : "") + ";\n";
}

void FinishFragment(
  const Request& r, std::vector<Varying> varyings, const std::string& scale, std::string& fragment)
{
  for (const Varying& own : OwnInputs())
  {
    if (!HasName(varyings, own.Name))
    {
      varyings.push_back(own);
    }
  }
  RemoveInputs(r, fragment, varyings);
  stock::Replace(fragment, Edit::FragmentDepth, "wfvDepth", stock::Found::May);
  stock::Replace(fragment, Edit::FrontFacing, "wfvFront", stock::Found::May);
  RewriteLights(r, fragment);
  const bool round = r.View.Projection->Axis == Family::Azimuthal;
  const std::string before = Before(r, fragment);
  wfv::ShaderBuilder::WrapMain(fragment, before,
    std::string("  if (wfvHide) { discard; }\n") +
      (round ? "  if (wfvOutsideDomain()) { discard; }\n" : ""));
  wfv::ShaderBuilder::Declare(fragment,
    "#extension GL_ARB_sample_shading : enable\n" + ViewSource(r) + depth_offset_glsl +
      Define("WFV_OTHER_IS_PLACE", IsSegment(r)) + "#define WFV_SPLAT_SCALE " + scale + "\n" +
      RaySource(r) + quadric_inputs_glsl +
      (NonCentralImpostors(r) ? quadric_non_central_glsl : "") + quadric_fragment_glsl +
      MeetSource(r.Kind) + CornerInputs(r, varyings) + (round ? domain_fragment_glsl : ""));
}
}

bool Draws(Primitive kind)
{
  return kind == Primitive::Spheres || kind == Primitive::Cylinders || kind == Primitive::Splats ||
    kind == Primitive::PointSpheres || kind == Primitive::Tubes;
}

void Prepare(const Request& r, std::string& geometry, std::string& fragment)
{
  geometry.clear();
  const std::string normal = "  vec3 normalVCVSOutput = wfvNormal;";
  if (r.Kind == Primitive::Tubes || r.Kind == Primitive::PointSpheres)
  {
    // the mapper would put its own, for a flat picture, in these places
    stock::Replace(fragment, Edit::NormalDeclaration, "", r.Stock.If(true));
    stock::Replace(fragment, Edit::DepthPlace, "", r.Stock.If(true));
    stock::Replace(fragment, Edit::NormalPlace, normal, r.Stock.If(true));
  }
  else if (r.Kind != Primitive::Splats)
  {
    // the mapper's own meeting of its impostor with the ray, which stands there already
    stock::Replace(fragment, Edit::ImpostorMeeting, normal, r.Stock.If(true));
  }
}

void Finish(const Request& r, std::string& vertex, std::string& geometry, std::string& fragment)
{
  FlattenArrays(r.Stock, vertex, fragment);
  TakeFromEye(r, vertex);
  const std::string scale = LookForShape(r, vertex);
  const std::vector<Varying> varyings = FindVaryings(vertex);
  geometry = GeometrySource(r, varyings);
  FinishFragment(r, varyings, scale, fragment);
}
}
}
