// SPDX-License-Identifier: BSD-3-Clause
#include "Compat/StockEdits.h"

#include "vtkVersionMacros.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <map>
#include <regex>

namespace wfv
{
namespace stock
{
namespace
{
constexpr bool Required = false;
constexpr bool Optional = true;
constexpr bool Pattern = true;

Wording Literal(int since, const char* text)
{
  return { since, text, false, nullptr };
}

Wording Matching(int since, const char* pattern)
{
  return { since, pattern, Pattern, nullptr };
}

// What was compared for it: VTK 9.1.0, 9.2.6, 9.3.0, 9.4.2, 9.5.2, 9.6.2, 9.7.0 and the master of
// August 2026. Where there is one wording, all of them have it.
const std::vector<Entry> AllEdits{
  // of any stage
  { Edit::MainFunction, "main function", "every stage that does more than VTK's", Required,
    { Matching(901, R"(void\s+main\s*\(\s*(void)?\s*\))") } },
  { Edit::Declarations, "declarations", "every stage made from VTK's templates", Required,
    { Literal(901, "//VTK::System::Dec") } },

  // of the vertex stage
  { Edit::FromEye, "vertex from the eye", "all but glyphs, which have two matrices", Required,
    { Matching(901, R"(\bMC[DV]CMatrix\s*\*\s*vertexMC\b)") } },
  { Edit::OutputArray, "array of outputs", "with clipping planes", Required,
    { Matching(901, R"(\bout\s+float\s+(\w+)\s*\[\s*(\d+)\s*\]\s*;)") } },
  { Edit::SphereRadius, "radius of a sphere", "sphere and stick mappers", Required,
    { Literal(901, "out float radiusVCVSOutput;") } },
  { Edit::CylinderAxis, "axis of a cylinder", "stick mappers", Required,
    { Matching(901, R"(out float lengthVCVSOutput;\s*out vec3 orientVCVSOutput;)") } },
  // 9.4 draws ellipses in squares that the vertex stage works out; not those of ellipsoids
  { Edit::SplatRadius, "radius of a splat", "point gaussians", Required,
    { Literal(901, "radiusVCVSOutput = radiusMC;"),
      Literal(904, "float radius = scaleFactor * radiusMC;") } },

  // of the fragment stage: what it takes in
  { Edit::Input, "input", "where it uses an output of the vertex stage", Required,
    { Matching(901, R"((flat\s+|smooth\s+|noperspective\s+)?\bin\s+@\s*;)") } },
  { Edit::InputArray, "array of inputs", "with clipping planes", Required,
    { Matching(901, R"(\bin\s+float\s+@\s*\[\s*\d+\s*\]\s*;)") } },

  // light
  { Edit::LightPlace, "place that light falls on", "with light", Required,
    { Literal(901, "vec4 vertexVC = vertexVCVSOutput;"),
      Literal(Unreleased, "vec4 vertexVC = vertexVCGSOutput;") } }, // behind VTK's geometry stages
  { Edit::HeadlightCosine, "cosine of a headlight", "with one headlight alone, not PBR", Required,
    { Matching(901, R"(max\((0\.0),normalVCVSOutput\.z\))"),
      Matching(902, R"(max\((0\.000001), normalVCVSOutput\.z\))") } },
  { Edit::LightDirection, "direction of a light", "with any other light, PBR or not", Required,
    { Matching(901, R"(\blightDirectionVC(\d+))") } },
  { Edit::LightUniform, "uniform of a light", "for speed: as a constant", Optional,
    { Literal(901, "uniform vec3 @;") } },
  { Edit::MaterialUniform, "uniform of a material", "for speed: as a constant", Optional,
    { Literal(901, "uniform float @;") } },

  // normals; up to 9.2 from either derivative of a line, since 9.3 from one vector
  { Edit::FlatNormal, "normal of a flat triangle", "lit triangles without normals", Required,
    { Literal(901, "normalize(cross(fdx,fdy))") } },
  { Edit::LineNormal, "normal of a line", "lit wireframes without normals", Required,
    { Matching(901, R"(normalize\(cross\(vec3\((fdx|fdy)\.y, -\1\.x, 0\.0\), \1\)\))"),
      Literal(903, "normalize(cross(vec3(lineVec.y, -lineVec.x, 0.0), lineVec))") } },
  // before, VTK asks gl_FrontFacing of lines too
  { Edit::LineFacing, "facing of a line", "lines with normals, of VTKs that look at z", Optional,
    { Literal(Unreleased, "if (normalVCVSOutput.z < 0)") } },

  // VTK's own geometry stage, which makes strips of wide lines
  { Edit::StripVertex, "vertex of a strip", "wide lines", Required,
    { Literal(901, "EmitVertex();") } },

  // GLSL's own variables, which no VTK can rename: where there is none, nothing is to be edited
  { Edit::FrontFacing, "gl_FrontFacing", "GLSL's own", Optional,
    { Literal(901, "gl_FrontFacing") } },
  { Edit::FragmentDepth, "gl_FragCoord.z", "GLSL's own", Optional,
    { Literal(901, "gl_FragCoord.z") } },
  { Edit::PointCoordinate, "gl_PointCoord", "GLSL's own", Optional,
    { Literal(901, "gl_PointCoord") } },
  { Edit::PrimitiveNumber, "gl_PrimitiveID", "GLSL's own", Optional,
    { Literal(901, "gl_PrimitiveID") } },
  { Edit::VertexNumber, "gl_VertexID", "GLSL's own", Optional, { Literal(901, "gl_VertexID") } },

  // VTK's places for text
  { Edit::DepthPlace, "place of the depth", "where nothing has set gl_FragDepth", Required,
    { Literal(901, "//VTK::Depth::Impl") } },
  { Edit::NormalDeclaration, "declaration of a normal", "tubes, points as spheres", Required,
    { Literal(901, "//VTK::Normal::Dec") } },
  { Edit::NormalPlace, "place of the normal", "tubes, points as spheres", Required,
    { Literal(901, "//VTK::Normal::Impl") } },
  { Edit::EdgesDeclaration, "declaration of edges", "surfaces with edges; data pass", Required,
    { Literal(901, "//VTK::Edges::Dec") } },
  { Edit::EdgesPlace, "place of edges", "surfaces with edges; data pass", Required,
    { Literal(901, "//VTK::Edges::Impl") } },
  { Edit::ColorsLightPlace, "place of light", "debug view", Required,
    { Literal(901, "//VTK::Light::Impl") } },
  { Edit::TextureColorPlace, "place of textures", "debug view", Required,
    { Literal(901, "//VTK::TCoord::Impl") } },
  { Edit::DataPlace, "place of the data", "data pass", Required,
    { Literal(901, "//VTK::DepthPeeling::Impl") } },

  // what other text of ours follows
  { Edit::ImpostorMeeting, "meeting of ray and impostor", "sphere and stick mappers", Required,
    { { 901, "  vec3 EyePos;", false, "gl_FragDepth = (pos.z / pos.w + 1.0) / 2.0;" } } },
  { Edit::DataNormal, "normal for the data", "data pass, with light; not wireframes", Required,
    { Literal(901, "vec3 normalVCVSOutput =") } },
  { Edit::DepthOffset, "offset of the depth", "where VTK shifts lines and points", Optional,
    { Literal(901, "uniform float cOffset;") } },
  { Edit::DepthOffsetValue, "value of the offset", "where VTK shifts lines and points", Optional,
    { Literal(901, "1.0*cOffset/65000") } },

  // of volumes, all by GPU ray casting: VTK's functions, ours take their names
  { Edit::VolumeRay, "ray of a volume", "volumes", Required,
    { Literal(901, "vec3 computeRayDirection()") } },
  { Edit::VolumePlace, "place at a depth", "volumes", Required,
    { Literal(901, "vec4 WindowToNDC(") } },
  { Edit::VolumeWindow, "depth of a place", "volumes", Required,
    { Literal(901, "vec4 NDCToWindow(") } },
  // in 9.6 the eye is a uniform for each input
  { Edit::VolumeToEye, "way to the eye", "volumes shaded by one headlight alone", Required,
    { Matching(901,
      R"(normalize\((?:g_lightPosObj|g_eyePosObjs|in_eyePosObjs)\[(\d+)\]\.xyz - ip_vertexPos\))") } },
  { Edit::VolumeLight, "light on a volume", "volumes shaded by other lights", Required,
    { Matching(901, R"(in_lightDirection\[(lightNum)\])"),
      Matching(902, R"(in_lightDirection\[(posNum|dirNum|i)\])") } },
  { Edit::VolumeSkip, "sample that is taken", "volumes along curves", Required,
    { Literal(901, "g_skip = false;") } },
  { Edit::VolumeAdvance, "way to the next sample", "volumes along curves", Required,
    { Literal(901, "g_dataPos += g_dirStep;") } },
  { Edit::VolumeLeave, "end of a volume", "volumes along curves", Required,
    { { 901, "if(any(greaterThan(max(g_dirStep, vec3(0.0))", false,
      "(g_dataPos - in_texMin[0]),vec3(0.0))))" } } },
  { Edit::VolumeClip, "clipping of a volume", "volumes along curves, with clipping planes",
    Required, { Literal(901, "bool AdjustSampleRangeForClipping(") } },
  // its first surfaces are drawn flat; without them a ray begins at the box
  { Edit::VolumeDepthPass, "beginning by a depth pass", "volumes with a depth pass", Optional,
    { Literal(901, "g_rayOrigin = rayOrigin.xyz;") } },
  { Edit::VolumeImageDepth, "depth of an image", "volumes that render to an image", Optional,
    { Literal(901, "depthValue /= depthValue.w;") } },
  // the sky
  { Edit::SkyDirection, "direction of the sky", "skyboxes", Required,
    { Literal(901, "normalize(TexCoords - cameraPos)") } },
  // 9.1 leaves a cube's level to OpenGL
  { Edit::SkyLookup, "texture of the sky", "skyboxes but floors", Required,
    { Matching(901, R"(texture\w*\(actortexture,)") } },
  { Edit::SkyHalf, "an eye's half of the sky", "skyboxes that are a sphere for each eye", Required,
    { Literal(901, "0.25 + 0.5*leftEye") } },
  { Edit::SkyFloorLookup, "texture of a floor", "floors", Required,
    { Literal(901, "texture(actortexture, vec2(dot(floorRight,pos), dot(floorFront, pos)))"),
      Literal(904,
        "texture(actortexture, vec2(dot(floorRight,pos)/floorTCoordScale.x, "
        "dot(floorFront, pos)/floorTCoordScale.y))") } },
  { Edit::SkyFloorEye, "eye above a floor", "floors", Required,
    { Literal(901, "p0 - cameraPos") } },
  { Edit::SkyFloorDepth, "depth of a floor", "floors", Required,
    { Literal(901, "gl_FragDepth = clamp(0.5 + 0.5*tpos.z/tpos.w,0.0,1.0);") } },
};

std::array<std::atomic<int>, static_cast<std::size_t>(Edit::Count)>& Counts()
{
  static std::array<std::atomic<int>, static_cast<std::size_t>(Edit::Count)> counts{};
  return counts;
}

const Entry& EntryOf(Edit edit)
{
  return Table()[static_cast<std::size_t>(edit)];
}

// In a text, for a name in place of what stands for it.
std::string Put(const std::string& text, const std::string& mark, const std::string& name)
{
  std::string out;
  std::size_t from = 0;
  for (std::size_t at = text.find(mark); at != std::string::npos; at = text.find(mark, from))
  {
    out += text.substr(from, at - from) + name;
    from = at + mark.size();
  }
  return out + text.substr(from);
}

const char* const Mark = "#error WideFoV edit ";

// One a line, for the number of a longer one does not begin with it.
std::string MarkOf(Edit edit)
{
  return Mark + std::to_string(static_cast<int>(edit)) + "\n";
}

// Made once: that takes longer than to look for it.
const std::regex& Compiled(const std::string& pattern)
{
  thread_local std::map<std::string, std::regex> known;
  const auto found = known.find(pattern);
  return found != known.end() ? found->second
                              : known.emplace(pattern, std::regex(pattern)).first->second;
}

Span FindWording(
  const std::string& text, const Wording& wording, const std::string& name, std::size_t from)
{
  const std::string wanted = Put(wording.Text, "@", name);
  Span span;
  if (wording.Pattern)
  {
    std::smatch m;
    const auto flags =
      from > 0 ? std::regex_constants::match_prev_avail : std::regex_constants::match_default;
    if (std::regex_search(text.begin() + from, text.end(), m, Compiled(wanted), flags))
    {
      span.At = from + m.position(0);
      span.Length = m.length(0);
      span.Groups.assign(m.begin() + 1, m.end());
    }
    return span;
  }
  const std::size_t at = text.find(wanted, from);
  const std::size_t last =
    wording.Last && at != std::string::npos ? text.find(wording.Last, at) : at;
  if (last != std::string::npos)
  {
    span.At = at;
    span.Length = wording.Last ? last + std::string(wording.Last).size() - at : wanted.size();
  }
  return span;
}

// What comes in the place of what was found.
std::string Replacement(const std::string& text, const Span& span, const std::string& by)
{
  const std::string out = Put(by, "$&", text.substr(span.At, span.Length));
  return span.Groups.empty() ? out : Put(out, "$1", span.Groups[0]);
}

void Count(std::string& text, Edit edit, Found found, int number)
{
  if (number >= 0)
  {
    Counts()[static_cast<std::size_t>(edit)]++;
  }
  else if (found == Found::Must && !EntryOf(edit).Optional &&
    text.find(MarkOf(edit)) == std::string::npos)
  {
    text += "\n" + MarkOf(edit);
  }
}
}

const std::vector<Entry>& Table()
{
  return AllEdits;
}

Span Find(const std::string& text, Edit edit, const std::string& name)
{
  const std::vector<Wording>& wordings = EntryOf(edit).Wordings;
  for (std::size_t i = 0; i < wordings.size(); i++)
  {
    Span span = FindWording(text, wordings[i], name, 0);
    if (span.At != std::string::npos)
    {
      span.Number = static_cast<int>(i);
      return span;
    }
  }
  return Span();
}

Span Look(std::string& text, Edit edit, Found found, const std::string& name)
{
  Span span = Find(text, edit, name);
  Count(text, edit, found, span.Number);
  return span;
}

int Replace(
  std::string& text, Edit edit, const std::string& by, Found found, const std::string& name)
{
  Span span = Find(text, edit, name);
  const int number = span.Number;
  while (span.At != std::string::npos)
  {
    const std::string put = Replacement(text, span, by);
    text.replace(span.At, span.Length, put);
    span = FindWording(text, EntryOf(edit).Wordings[number], name, span.At + put.size());
  }
  Count(text, edit, found, number);
  return number;
}

std::vector<Edit> Missing(const std::string& text)
{
  std::vector<Edit> missing;
  if (text.find(Mark) == std::string::npos)
  {
    return missing;
  }
  for (const Entry& entry : Table())
  {
    if (text.find(MarkOf(entry.Which)) != std::string::npos)
    {
      missing.push_back(entry.Which);
    }
  }
  return missing;
}

bool HasEdgeOpacity()
{
  return VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0);
}

int TimesFound(Edit edit)
{
  return Counts()[static_cast<std::size_t>(edit)];
}
}
}
