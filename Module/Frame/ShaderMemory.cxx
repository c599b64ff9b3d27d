// SPDX-License-Identifier: BSD-3-Clause
#include "Frame/ShaderMemory.h"

namespace
{
// More variants than a program has at a time; each takes some ten kilobytes.
constexpr std::size_t MostTexts = 200;

template <typename... Values>
void Append(std::string& key, const Values&... values)
{
  // of a pointer itself, too: NOLINTNEXTLINE(bugprone-sizeof-expression)
  (key.append(reinterpret_cast<const char*>(&values), sizeof(values)), ...);
}

// All fields: the compiler counts them here.
void AppendRequest(std::string& key, const wfv::ShaderBuilder::Request& request)
{
  const auto& [view, stage, kind, points, lines, triangles, lights, surface, runs, debugView,
    stock] = request;
  const auto& [projection, stereo, depthMapping, multisample, tilted, lensed, fades, seam] = view;
  const auto& [edges, edgeFlags, byRays, fp64] = triangles;
  const auto& [headlights, constants] = lights;
  const auto& [noAmbient, noDiffuse, fullDiffuse, noSpecular, opaque] = surface;
  const auto& [known, light, physical, normals, wireframe, glyphs, clips, impostors] = stock;
  Append(key, projection, stereo, depthMapping, multisample, tilted, lensed, fades, seam);
  Append(key, stage, kind, points.Wide, lines.Wide, runs, debugView);
  Append(key, edges, edgeFlags, byRays, fp64);
  Append(key, headlights, noAmbient, noDiffuse, fullDiffuse, noSpecular, opaque);
  Append(key, known, light, physical, normals, wireframe, glyphs, clips, impostors);
  key += constants ? *constants : "";
  key += '\0'; // where they end
}
}

namespace wfv
{
const ShaderMemory::Texts* ShaderMemory::Find(
  const Request& request, const Circumstances& circumstances, const Texts& texts)
{
  this->Wanted.clear();
  AppendRequest(this->Wanted, request);
  Append(this->Wanted, circumstances.Numbered, circumstances.Others);
  for (const std::string* const text : { &texts.Vertex, &texts.Geometry, &texts.Fragment })
  {
    Append(this->Wanted, text->size());
    this->Wanted += *text;
  }
  const auto found = this->Made.find(this->Wanted);
  return found == this->Made.end() ? nullptr : &found->second;
}

void ShaderMemory::Keep(const Texts& made)
{
  if (this->Made.size() >= MostTexts)
  {
    this->Made.clear();
  }
  this->Made[this->Wanted] = made;
}
}
