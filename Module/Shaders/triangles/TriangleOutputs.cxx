// SPDX-License-Identifier: BSD-3-Clause
#include "Shaders/triangles/TriangleOutputs.h"

#include "WideFoVGlsl.h"

#include <algorithm>
#include <iterator>

namespace wfv
{
namespace shader
{
namespace
{
// Vertices of all shapes of one triangle, and of one of them.
constexpr int MostVertices = 14;
constexpr int ShapeVertices = 4;

// Of one vertex, what preclip_emit.glsl writes beside the copies of the corners.
int OwnComponents(const Request& r)
{
  const bool exact = r.ByRays || r.Stage == wfv::ShaderBuilder::Variant::Exact;
  const bool rays = NonCentral(r);
  const int edges = r.Fp64 ? 3 * 3 * 2 : 3 * 3; // doubles count twice
  const int plane = 3 + (rays || CurvedRays(r) ? 3 : 5);
  const int chords = 3 + 3 + 3 + 4 + 2 + 4 + 1;
  const int order = 3 + 3;
  return 4 + 1 + edges + plane + (exact ? order : chords) + (rays ? 3 * 3 : 0) + r.DebugView +
    (CurvedRays(r) ? 2 : 0) + (r.MeetsChords ? 3 + 4 + 2 : 0) + (r.SeveralChords ? 3 + 3 * 3 : 0);
}
}

std::string InvocationsSource(
  const Request& r, const std::vector<Varying>& varyings, const Known& known)
{
  std::vector<Varying> copied;
  std::copy_if(varyings.begin(), varyings.end(), std::back_inserter(copied),
    [&known](const Varying& v) { return known.count(v.Name) == 0; });
  const int components = OwnComponents(r) + CornerComponents(copied, 3);
  const int allowed = std::max(MostComponents / components, ShapeVertices);
  // a part begins with the last two vertices of the one before, the first of them perhaps twice
  const int own = allowed - 3;
  const int parts = MostVertices <= allowed ? 1 : (MostVertices - 2 + own - 1) / own;
  // (a stage without invocations writes all at once, and the driver decides)
  return "#ifdef GL_ARB_gpu_shader5\n" + Define("WFV_EMIT_PARTS", parts) +
    Define("WFV_EMIT_VERTICES", std::min(MostVertices, allowed)) +
    Define("WFV_INVOCATIONS", r.Runs * parts) +
    (r.Runs > 1 ? "#define WFV_RUN (gl_InvocationID / WFV_EMIT_PARTS)\n" : Define("WFV_RUN", 0)) +
    (parts > 1 ? emit_parts_glsl : "") + "#else\n#undef WFV_RUNS\n" + Define("WFV_RUNS", 1) +
    Define("WFV_RUN", 0) + Define("WFV_EMIT_PARTS", 1) + Define("WFV_INVOCATIONS", 1) +
    Define("WFV_EMIT_VERTICES", MostVertices) + "#endif\n";
}
}
}
