// SPDX-License-Identifier: BSD-3-Clause
// Every edit of VTK's own shader text, by name: what it looks for in which VTK. The table is in
// StockEdits.cxx; to port to another VTK is to compare that page with its shaders.
//
// An edit that finds nothing where it must leaves a mark in the text, GLSL's own #error: a shader
// with a mark in it is never drawn with (StockText.h), and would not even compile.
#ifndef WideFoVStockEdits_h
#define WideFoVStockEdits_h

#include "Projections/Projection.h"

#include <string>
#include <vector>

namespace wfv
{
namespace stock
{
enum class Edit
{
  // of any stage
  MainFunction,
  Declarations,
  // of the vertex stage
  FromEye,
  OutputArray,
  SphereRadius,
  CylinderAxis,
  SplatRadius,
  // of the fragment stage: what it takes in
  Input,
  InputArray,
  // light
  LightPlace,
  HeadlightCosine,
  LightDirection,
  LightUniform,
  MaterialUniform,
  // normals
  FlatNormal,
  LineNormal,
  LineFacing,
  // of the geometry stage
  StripVertex,
  // GLSL's own variables
  FrontFacing,
  FragmentDepth,
  PointCoordinate,
  PrimitiveNumber,
  VertexNumber,
  // VTK's places for text
  DepthPlace,
  NormalDeclaration,
  NormalPlace,
  EdgesDeclaration,
  EdgesPlace,
  ColorsLightPlace,
  TextureColorPlace,
  DataPlace,
  // what other text of ours follows
  ImpostorMeeting,
  DataNormal,
  DepthOffset,
  DepthOffsetValue,
  // volumes
  VolumeRay,
  VolumePlace,
  VolumeWindow,
  VolumeToEye,
  VolumeLight,
  VolumeSkip,
  VolumeAdvance,
  VolumeLeave,
  VolumeClip,
  VolumeDepthPass,
  VolumeImageDepth,
  // the sky
  SkyDirection,
  SkyLookup,
  SkyHalf,
  SkyFloorLookup,
  SkyFloorEye,
  SkyFloorDepth,
  Count
};

// What the master of August 2026 has, and not 9.7.
constexpr int Unreleased = 99999;

// One way in which VTK writes it.
struct Wording
{
  int Since;        // the first VTK that has it, 901 for 9.1; or Unreleased
  const char* Text; // "@" stands for the name that the edit is called with
  bool Pattern;     // a regular expression
  const char* Last; // or all up to the end of this, which follows; null: Text alone
};

struct Entry
{
  Edit Which;
  const char* Name;
  const char* Where; // in which shaders it must be found; what it is for, where it need not be
  bool Optional;     // nothing is wrong where it is not found, whatever the shader
  std::vector<Wording> Wordings;
};

// All, in the order of the enumeration.
WFV_EXPORT const std::vector<Entry>& Table();

enum class Found
{
  Must, // by what is known of the mapper, not by the text
  May
};

enum class Lit
{
  No,
  Headlight, // by one alone
  Otherwise
};

// What the mapper that draws says of the text that VTK writes for it (StockTraits.h).
struct Traits
{
  bool Known = false; // all of it is VTK's own: nobody else's code, no volume
  Lit Light = Lit::No;
  bool Physical = false; // PBR
  bool Normals = false;  // are given, of points or of cells
  bool Wireframe = false;
  bool Glyphs = false;    // placed by a matrix each
  bool Clips = false;     // has clipping planes
  bool Impostors = false; // VTK's geometry stage makes spheres, cylinders or splats of points

  // Whether what a shader has if `has` must be found.
  Found If(bool has) const { return this->Known && has ? Found::Must : Found::May; }
};

// Replaces all that the edit looks for. In `by`, "$&" is what was found and "$1" the pattern's
// first group. Returns the number of the wording, or -1 where none was found: then the text has a
// mark, if it must be found and the edit is not optional.
WFV_EXPORT int Replace(std::string& text, Edit edit, const std::string& by,
  Found found = Found::Must, const std::string& name = "");

// The first text of an edit that is found.
struct Span
{
  int Number = -1; // of the wording; -1: none
  std::size_t At = std::string::npos;
  std::size_t Length = 0;
  std::vector<std::string> Groups; // of a pattern
};
WFV_EXPORT Span Find(const std::string& text, Edit edit, const std::string& name = "");

// The same, and marks the text as Replace does.
WFV_EXPORT Span Look(
  std::string& text, Edit edit, Found found = Found::Must, const std::string& name = "");

// The edits whose marks are in a text.
WFV_EXPORT std::vector<Edit> Missing(const std::string& text);

// Whether the mapper sets a uniform edgeOpacity: since VTK 9.3.
bool HasEdgeOpacity();

// How often Replace or Look found it, in this process: for tests.
WFV_EXPORT int TimesFound(Edit edit);
}
}

#endif
