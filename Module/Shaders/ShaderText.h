// SPDX-License-Identifier: BSD-3-Clause
// Shader text taken apart and put together: what the parts of the shader builder share.
#ifndef WideFoVShaderText_h
#define WideFoVShaderText_h

#include "Shaders/ShaderBuilder.h"

#include <map>
#include <string>
#include <vector>

namespace wfv
{
namespace shader
{
using Request = wfv::ShaderBuilder::Request;
using Primitive = wfv::ShaderBuilder::Primitive;

// OpenGL lets an invocation of a geometry stage write so many components, over all its vertices;
// no driver need allow more (GL_MAX_GEOMETRY_TOTAL_OUTPUT_COMPONENTS), and NVIDIA's does not.
constexpr int MostComponents = 1024;

// One output of the vertex stage.
struct Varying
{
  bool Flat;
  std::string Type;
  std::string Name;

  // As the geometry stage takes it in: one a vertex.
  std::string Input() const
  {
    return (this->Flat ? "flat in " : "in ") + this->Type + " " + this->Name + "[];\n";
  }

  std::string Declaration(const std::string& name) const { return this->Type + " " + name + ";\n"; }

  // Floats or integers in it: what OpenGL counts.
  int Components() const;
};

std::vector<Varying> FindVaryings(const std::string& vertex);

// Takes the fragment stage's declarations of these inputs out.
void RemoveInputs(const Request& r, std::string& fragment, const std::vector<Varying>& varyings);

// Turns what is known of the material from uniforms into constants, so that a compiler drops
// what they multiply.
void FoldMaterial(const wfv::ShaderBuilder::Material& surface, std::string& fragment);

void ReplaceAll(std::string& text, const std::string& from, const std::string& to);

std::string Define(const char* name, int value);

// Name of the copy of an output at a corner of the primitive.
std::string Corner(size_t varying, int corner);

// Outputs that the fragment stage knows without copies, and what it takes for them.
using Known = std::map<std::string, std::string>;

// For the geometry stage: declares the copies for primitives of so many corners, and
// wfvWriteCorners(), which sets them.
std::string CornerOutputs(
  const std::vector<Varying>& varyings, int corners, const Known& known = {});

// For the fragment stage: declares the outputs as plain variables, and wfvInterpolate(),
// which sets them from the copies and one weight a corner, an expression in GLSL. What is
// flat has the value of the last corner.
std::string CornerInputs(const std::vector<Varying>& varyings,
  const std::vector<std::string>& weights, const Known& known = {});

// For a geometry stage that emits points between the corners: wfvWriteMix(), with this parameter,
// sets every output from the corners' by one weight each, an expression in GLSL; what is flat is
// the last corner's.
std::string MixedOutputs(const std::vector<Varying>& varyings, const std::string& parameter,
  const std::vector<std::string>& weights);

// Components of all copies.
int CornerComponents(const std::vector<Varying>& varyings, int corners, const Known& known = {});

// True where nothing is drawn by its chords: WFV_EXACT.
bool IsExact(const Request& r);

// True for triangles and lines of an eye with non-central rays.
bool NonCentral(const Request& r);

// True for spheres, cylinders, tubes and splats of an eye with non-central rays.
bool NonCentralImpostors(const Request& r);

// True for triangles of an eye whose rays are no straight lines.
bool CurvedRays(const Request& r);

// The mathematics of the view, for any stage.
std::string ViewSource(const Request& request);

// Of edges in the map, for any stage behind that.
std::string EdgeSource();

// The rays of a fragment, for a fragment stage behind that.
std::string RaySource(const Request& request);

// The wide camera's view and clip coordinates are the same; both stock statements are
// replaced, so that neighbours and attributes agree to the bit. Returns the name of the
// matrix, empty where there is none. keepModel: the vertex as the buffer has it goes on to the
// next stage, as wfvModel.
std::string TakeFromEye(const Request& r, std::string& vertex, bool keepModel = false);

// The normal of a surface without normals: of the triangle, not from differences between
// pixels. For a fragment stage that knows it (cover_fragment.glsl).
void RewriteFlatNormal(const Request& r, std::string& fragment);

// The stock text takes normal.z for the cosine towards the eye and the view axis for
// the direction of a headlight; both hold in front of the eye only.
void RewriteLights(const Request& r, std::string& fragment);

// VTK's offset of the depth of lines and points is made for a perspective (depth_offset.glsl).
void RewriteOffset(std::string& fragment);

// Depth by wfvDepth instead of the rasterizer's; returns what main begins with.
std::string RewriteDepth(const Request& r, std::string& fragment);
}
}

#endif
