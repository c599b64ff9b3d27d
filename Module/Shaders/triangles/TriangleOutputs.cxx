// SPDX-License-Identifier: BSD-3-Clause
#include "Shaders/triangles/TriangleOutputs.h"

#include "WideFoVGlsl.h"

#include <algorithm>

namespace wfv
{
namespace shader
{
namespace
{
// Vertices of all shapes of one triangle, and of one of them.
constexpr int MostVertices = 14;
constexpr int ShapeVertices = 4;

// What leaves the stage, one file each.
struct Output
{
  bool Is;            // of this request
  int Components;     // floats and integers of a vertex; doubles count twice
  const char* Source; // declares it, and the function
  const char* Write;  // that writes it
};

std::vector<Output> OutputsOf(const Request& r)
{
  const bool exact = IsExact(r);
  const bool anchored = NonCentral(r) || CurvedRays(r);
  const int edges = r.Triangles.Fp64 ? 3 * 3 * 2 : 3 * 3;
  std::vector<Output> all{ { true, edges + 3, preclip_outputs_glsl, "wfvWriteEdges" },
    { anchored, 3, out_anchor_glsl, "wfvWriteAnchor" },
    { !anchored, 3 + 2, out_meets_glsl, "wfvWriteMeets" },
    { !exact, 3 + 3 + 3, out_projected_glsl, "wfvWriteSlack" },
    { !exact, 4 + 2, out_corners_glsl, "wfvWritePlaces" },
    { CrossesSeam(r), 4, out_seam_glsl, "wfvWriteSeam" },
    { !exact || r.DebugView, 1, out_mode_glsl, "wfvWriteMode" },
    { NonCentral(r), 3 * 3, out_spans_glsl, "wfvWriteSpans" },
    { exact, 3 + 3, out_rises_glsl, "wfvWriteRises" },
    { CurvedRays(r), 2, out_depths_glsl, "wfvWriteDepths" } };
  all.erase(
    std::remove_if(all.begin(), all.end(), [](const Output& o) { return !o.Is; }), all.end());
  return all;
}

// Of one vertex, beside the copies of the corners: with gl_Position and gl_PrimitiveID.
int OwnComponents(const Request& r)
{
  int count = 4 + 1;
  for (const Output& o : OutputsOf(r))
  {
    count += o.Components;
  }
  return count;
}
}

bool CrossesSeam(const Request& r)
{
  return !IsExact(r) && r.View.Projection->Axis == Family::Meridian &&
    r.View.Projection->StraightSeam;
}

std::string OutputsSource(const Request& r)
{
  std::string source;
  std::string writes;
  for (const Output& o : OutputsOf(r))
  {
    source += o.Source;
    writes += std::string("  ") + o.Write + "();\n";
  }
  return source + "void wfvWriteFlat()\n{\n" + writes + "}\n";
}

std::string InvocationsSource(
  const Request& r, const std::vector<Varying>& varyings, const Known& known)
{
  const int components = OwnComponents(r) + CornerComponents(varyings, 3, known);
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
