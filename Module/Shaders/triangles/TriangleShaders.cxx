// SPDX-License-Identifier: BSD-3-Clause
#include "Shaders/triangles/TriangleShaders.h"

#include "Shaders/Fp64Text.h"
#include "Shaders/triangles/TriangleOutputs.h"
#include "WideFoVGlsl.h"

namespace wfv
{
namespace triangle
{
using namespace shader;

namespace
{
// How the picture of a triangle is covered, one file a family.
std::string CoverSource(const Projection& projection)
{
  switch (projection.Axis)
  {
    case Family::Meridian:
      return projection.StraightSeam ? cover_meridian_glsl : cover_curved_seam_glsl;
    case Family::Faces:
      return cover_faces_glsl;
    case Family::Sampled:
      return cover_directions_glsl;
    default:
      return cover_azimuthal_glsl;
  }
}

// What follows from the ray and the distance, where triangles are ray-tested whatever their edges.
Known KnownOf(const Request& r)
{
  return IsExact(r) ? Known{ { "vertexVCVSOutput", "vec4(wfvSurface, 1.0)" },
    { "wfvPositionVSOutput", "wfvSurface" } }
                    : Known{};
}

// Planes through the eye: in double, where OpenGL has that.
std::string PlaneSource(const Request& r)
{
  return std::string(preclip_planes_glsl) +
    (r.View.Projection->Axis == Family::Faces ? planes_turn_glsl : "") +
    "#ifdef GL_ARB_gpu_shader_fp64\n" + planes_fp64_glsl + "#else\n" + planes_fp32_glsl +
    "#endif\n" + preclip_facing_glsl;
}

// What of a triangle the ray of a pixel sees: one file a question, in the order in which they ask.
std::string HitSource(const Request& r)
{
  const bool anchored = NonCentral(r) || CurvedRays(r);
  return std::string(cover_precision_glsl) + cover_inputs_glsl +
    (NonCentral(r) ? cover_non_central_glsl : "") + cover_edges_glsl +
    (anchored ? cover_anchor_glsl : cover_plane_glsl) + cover_surface_glsl + cover_samples_glsl +
    cover_hit_glsl + cover_fragment_glsl;
}

// Where it ends.
std::string BorderSource(const Request& r)
{
  if (IsExact(r))
  {
    return std::string(edge_inside_glsl) + no_chords_glsl;
  }
  const bool seam = CrossesSeam(r);
  return edge_inside_glsl + Define("WFV_CROSSES_SEAM", seam) + (seam ? chord_seam_glsl : "") +
    chord_fragment_glsl;
}
}

bool Covers(const Request& r)
{
  return ShaderBuilder::NeedsGeometryStage(r) && r.Kind == Primitive::Triangles;
}

std::string GeometrySource(const Request& r, const std::vector<Varying>& varyings)
{
  // copies of every vertex output at the three corners, which the fragment stage weighs:
  // exact wherever the geometry stage cuts
  return InvocationsSource(r, varyings, KnownOf(r)) + CornerOutputs(varyings, 3, KnownOf(r)) +
    cover_precision_glsl + OutputsSource(r) + preclip_write_glsl + preclip_emit_glsl +
    PlaneSource(r) + (NonCentral(r) ? std::string(non_central_glsl) + non_central_edges_glsl : "") +
    (CurvedRays(r) ? curved_cover_glsl : "") + preclip_cover_glsl + preclip_narrow_glsl +
    CoverSource(*r.View.Projection) + (r.DebugView ? preclip_kinds_glsl : "") + preclip_seen_glsl +
    (NonCentral(r) ? "" : preclip_grazes_glsl) + preclip_easy_glsl + preclip_measure_glsl +
    (IsExact(r) ? preclip_exact_glsl : preclip_chords_glsl) + preclip_triangles_glsl;
}

std::string FragmentSource(
  const Request& r, const std::vector<Varying>& varyings, std::string& fragment)
{
  RewriteFlatNormal(r, fragment);
  return RaySource(r) + (r.Triangles.Fp64 ? Fp64Source(*r.View.Projection) : "") + HitSource(r) +
    (CurvedRays(r) ? std::string(curved_ray_glsl) + curved_fragment_glsl : "") + BorderSource(r) +
    order_fragment_glsl + (r.Triangles.Fp64 ? fine_depth_glsl : "") +
    (r.Triangles.Edges || r.DebugView ? edge_distance_glsl : "") +
    CornerInputs(varyings, { "wfvB.x", "wfvB.y", "wfvB.z" }, KnownOf(r));
}
}
}
