// SPDX-License-Identifier: BSD-3-Clause
// What there is: the projection files compiled as C++, and one entry for each.
#include "Projection.h"

#include "DirectionMap/DirectionTables.h"
#include "WideFoVGlsl.h"

// A file may leave out what its family offers it, such as the view.
#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-parameter"
#endif
#define float double
#define WFV_LENSED true
namespace wfv
{
namespace equirectangular
{
#include "equirectangular.glsl"
#include "library/cylindrical.glsl"
#include "library/meridian.glsl"
#include "library/unproject.glsl"
}
namespace cylindrical_equal_area
{
#include "cylindrical-equal-area.glsl"
#include "library/cylindrical.glsl"
#include "library/meridian.glsl"
#include "library/unproject.glsl"
}
namespace miller
{
#include "miller.glsl"
#include "library/cylindrical.glsl"
#include "library/meridian.glsl"
#include "library/unproject.glsl"
}
namespace mercator
{
#include "mercator.glsl"
#include "library/cylindrical.glsl"
#include "library/meridian.glsl"
#include "library/unproject.glsl"
}
namespace central_cylindrical
{
#include "central-cylindrical.glsl"
#include "library/cylindrical.glsl"
#include "library/meridian.glsl"
#include "library/unproject.glsl"
}
namespace sinusoidal
{
#include "sinusoidal.glsl"
#include "library/pseudocylindrical.glsl"
#include "library/meridian.glsl"
#include "library/unproject.glsl"
}
namespace mollweide
{
#include "library/arc_minus_sine.glsl"
#include "mollweide.glsl"
#include "library/pseudocylindrical.glsl"
#include "library/meridian.glsl"
#include "library/unproject.glsl"
}
namespace eckert_iv
{
#include "library/arc_minus_sine.glsl"
#include "eckert-iv.glsl"
#include "library/pseudocylindrical.glsl"
#include "library/meridian.glsl"
#include "library/unproject.glsl"
}
namespace hammer
{
#include "hammer.glsl"
#include "library/half_longitude.glsl"
#include "library/meridian.glsl"
#include "library/unproject.glsl"
}
namespace aitoff
{
#include "aitoff.glsl"
#include "library/half_longitude.glsl"
#include "library/meridian.glsl"
#include "library/unproject.glsl"
}
namespace winkel_tripel
{
#include "winkel-tripel.glsl"
#include "library/half_longitude.glsl"
#include "library/meridian.glsl"
#include "library/unproject.glsl"
}
namespace panini
{
#include "panini.glsl"
#include "library/meridian.glsl"
#include "library/unproject.glsl"
}
namespace azimuthal_equidistant
{
#include "azimuthal-equidistant.glsl"
#include "library/lens.glsl"
#include "library/azimuthal.glsl"
#include "library/unproject.glsl"
}
namespace azimuthal_equal_area
{
#include "azimuthal-equal-area.glsl"
#include "library/azimuthal.glsl"
#include "library/unproject.glsl"
}
namespace stereographic
{
#include "stereographic.glsl"
#include "library/azimuthal.glsl"
#include "library/unproject.glsl"
}
namespace orthographic
{
#include "orthographic.glsl"
#include "library/azimuthal.glsl"
#include "library/unproject.glsl"
}
namespace gnomonic
{
#include "library/rectilinear.glsl"
#include "gnomonic.glsl"
#include "library/azimuthal.glsl"
#include "library/unproject.glsl"
}
namespace brown_conrady
{
#include "library/rectilinear.glsl"
#include "brown-conrady.glsl"
#include "library/lens.glsl"
#include "library/azimuthal.glsl"
#include "library/unproject.glsl"
}
namespace equi_angular_cubemap
{
#include "library/cube_faces.glsl"
#include "equi-angular-cubemap.glsl"
#include "library/unproject.glsl"
}
namespace perspective
{
#include "perspective.glsl"
#include "library/unproject.glsl"
}
}
#undef float
#undef WFV_LENSED
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

namespace wfv
{
namespace
{
// Largest field of view of the perspective, degrees: beyond, float32 tells no tangents apart.
constexpr double MaxPerspective = 179;

const char* const PolesAtInfinity = "its poles are infinitely far away";

// A projection before its family's and its own traits: the functions of one of the
// namespaces above, and the text of its files in the order in which they are included.
#define WFV_PROJECTION(ns, name, title, properties, ...)                                           \
  MakeProjection(name, title, properties,                                                          \
    { ns::wfvMap, ns::wfvProject, ns::wfvUnproject, ns::wfvBounds }, { __VA_ARGS__ })

struct Functions
{
  decltype(Projection::Map) Map;
  decltype(Projection::Project) Project;
  decltype(Projection::Unproject) Unproject;
  decltype(Projection::Bounds) Bounds;
};

Projection MakeProjection(const char* name, const char* title, const char* properties,
  const Functions& f, const std::vector<const char*>& sources)
{
  Projection p;
  p.Name = name;
  p.Title = title;
  p.Properties = properties;
  p.Map = f.Map;
  p.Project = f.Project;
  p.Unproject = f.Unproject;
  p.Bounds = f.Bounds;
  for (const char* source : sources)
  {
    p.Glsl += source;
  }
  p.Glsl += unproject_glsl;
  return p;
}

// x is the longitude: the seam is straight, on both borders.
Projection Cylindrical(Projection p, double maxVertical = 180)
{
  p.MaxVerticalFov = maxVertical;
  p.UnboundedPoles = true;
  p.Limit = maxVertical < 180 ? PolesAtInfinity : "";
  return p;
}

// The seam is the curved border of the map of the sphere.
Projection Curved(Projection p, bool polesAreLines = false)
{
  p.StraightSeam = false;
  p.UnboundedPoles = polesAreLines;
  return p;
}

Projection Round(Projection p, double maxFov)
{
  p.Axis = Family::Azimuthal;
  p.MaxHorizontalFov = p.MaxVerticalFov = maxFov;
  p.StraightSeam = false;
  p.UnboundedPoles = true;
  return p;
}

Projection Fisheye(Projection p)
{
  p = Round(p, 360);
  p.HasLens = true;
  return p;
}

Projection Panini(Projection p)
{
  p = Curved(p, true);
  p.MaxHorizontalFov = panini::WFV_MOST_WIDTH;
  p.MaxVerticalFov = panini::WFV_MOST_HEIGHT;
  p.Limit = "what is beyond is drawn towards infinity";
  return p;
}

Projection Stereographic(Projection p)
{
  p = Round(p, stereographic::WFV_MOST_FOV);
  p.Limit = "the antipode is infinitely far away";
  return p;
}

Projection Orthographic(Projection p)
{
  p = Round(p, 180);
  p.FlatRim = true;
  p.Limit = "it shows the half sphere ahead";
  return p;
}

Projection Gnomonic(Projection p)
{
  p = Round(p, gnomonic::WFV_MOST_FOV);
  p.Limit = "what is 90 degrees off the axis is infinitely far away";
  return p;
}

Projection BrownConrady(Projection p)
{
  p = Round(p, brown_conrady::WFV_MOST_FOV);
  p.HasLens = true;
  p.Limit = "what is 90 degrees off the axis is infinitely far away";
  return p;
}

Projection Faces(Projection p)
{
  p.Axis = Family::Faces;
  p.MinHorizontalFov = 360;
  p.MinVerticalFov = 180;
  p.StraightSeam = false;
  p.Limit = "it always shows the whole sphere";
  return p;
}

Projection Planar(Projection p)
{
  p.Axis = Family::Planar;
  p.MaxHorizontalFov = p.MaxVerticalFov = MaxPerspective;
  return p;
}

std::vector<Projection> CylindricalOnes()
{
  return {
    Cylindrical(WFV_PROJECTION(equirectangular, "equirectangular", "Equirectangular", "equidistant",
      equirectangular_glsl, cylindrical_glsl, meridian_glsl)),
    Cylindrical(WFV_PROJECTION(cylindrical_equal_area, "cylindrical-equal-area",
      "Cylindrical equal-area (Lambert)", "equal-area, straight-meridians",
      cylindrical_equal_area_glsl, cylindrical_glsl, meridian_glsl)),
    Cylindrical(WFV_PROJECTION(miller, "miller", "Miller cylindrical", "straight-meridians",
      miller_glsl, cylindrical_glsl, meridian_glsl)),
    Cylindrical(WFV_PROJECTION(mercator, "mercator", "Mercator", "conformal, straight-meridians",
                  mercator_glsl, cylindrical_glsl, meridian_glsl),
      mercator::WFV_MOST_HEIGHT),
    Cylindrical(WFV_PROJECTION(central_cylindrical, "central-cylindrical", "Central cylindrical",
                  "straight-meridians", central_cylindrical_glsl, cylindrical_glsl, meridian_glsl),
      central_cylindrical::WFV_MOST_HEIGHT),
    Panini(WFV_PROJECTION(panini, "panini", "Panini", "straight-meridians, straight-radials",
      panini_glsl, meridian_glsl)),
  };
}

std::vector<Projection> CurvedOnes()
{
  return {
    Curved(WFV_PROJECTION(
      hammer, "hammer", "Hammer", "equal-area", hammer_glsl, half_longitude_glsl, meridian_glsl)),
    Curved(WFV_PROJECTION(aitoff, "aitoff", "Aitoff", "equidistant-axes", aitoff_glsl,
      half_longitude_glsl, meridian_glsl)),
    Curved(WFV_PROJECTION(winkel_tripel, "winkel-tripel", "Winkel tripel", "equidistant-axes",
             winkel_tripel_glsl, half_longitude_glsl, meridian_glsl),
      true),
    Curved(WFV_PROJECTION(mollweide, "mollweide", "Mollweide", "equal-area, straight-parallels",
      arc_minus_sine_glsl, mollweide_glsl, pseudocylindrical_glsl, meridian_glsl)),
    Curved(WFV_PROJECTION(sinusoidal, "sinusoidal", "Sinusoidal",
      "equal-area, equidistant-axes, straight-parallels", sinusoidal_glsl, pseudocylindrical_glsl,
      meridian_glsl)),
    Curved(WFV_PROJECTION(eckert_iv, "eckert-iv", "Eckert IV", "equal-area, straight-parallels",
             arc_minus_sine_glsl, eckert_iv_glsl, pseudocylindrical_glsl, meridian_glsl),
      true),
  };
}

std::vector<Projection> OtherOnes()
{
  return {
    Fisheye(WFV_PROJECTION(azimuthal_equidistant, "azimuthal-equidistant",
      "Azimuthal equidistant (fisheye, dome)", "equidistant", azimuthal_equidistant_glsl, lens_glsl,
      azimuthal_glsl)),
    Round(WFV_PROJECTION(azimuthal_equal_area, "azimuthal-equal-area",
            "Azimuthal equal-area (equisolid fisheye)", "equal-area, straight-radials",
            azimuthal_equal_area_glsl, azimuthal_glsl),
      360),
    Stereographic(WFV_PROJECTION(stereographic, "stereographic", "Stereographic",
      "conformal, straight-radials", stereographic_glsl, azimuthal_glsl)),
    Orthographic(WFV_PROJECTION(orthographic, "orthographic", "Orthographic (fisheye)",
      "straight-radials", orthographic_glsl, azimuthal_glsl)),
    Gnomonic(WFV_PROJECTION(gnomonic, "gnomonic", "Gnomonic (rectilinear fisheye)",
      "straight-lines, straight-radials", rectilinear_glsl, gnomonic_glsl, azimuthal_glsl)),
    BrownConrady(
      WFV_PROJECTION(brown_conrady, "brown-conrady", "Brown-Conrady (rectilinear lens, measured)",
        "straight-radials", rectilinear_glsl, brown_conrady_glsl, lens_glsl, azimuthal_glsl)),
    Faces(WFV_PROJECTION(equi_angular_cubemap, "equi-angular-cubemap", "Equi-angular cubemap (3x2)",
      "equiangular", cube_faces_glsl, equi_angular_cubemap_glsl)),
    Planar(WFV_PROJECTION(
      perspective, "perspective", "Perspective", "straight-lines", perspective_glsl)),
  };
}
}

const std::vector<Projection>& Projections()
{
  static const std::vector<Projection> all = [] {
    std::vector<Projection> list = CylindricalOnes();
    for (const std::vector<Projection>& some : { CurvedOnes(), OtherOnes() })
    {
      list.insert(list.end(), some.begin(), some.end());
    }
    return list;
  }();
  return all;
}

const Projection& SampledProjection()
{
  static const Projection sampled = [] {
    Projection p = WFV_PROJECTION(tables, "direction-map", "Direction map", "sampled",
      cube_faces_glsl, direction_rays_glsl, direction_places_glsl, direction_map_glsl);
    p.Axis = Family::Sampled;
    p.MinHorizontalFov = 360;
    p.MinVerticalFov = 180;
    p.StraightSeam = false;
    p.Limit = "it shows what its file says";
    return p;
  }();
  return sampled;
}

const Projection& FramedPerspective()
{
  static const Projection framed = [] {
    Projection p = Gnomonic(WFV_PROJECTION(gnomonic, "perspective", "Perspective", "straight-lines",
      rectilinear_glsl, gnomonic_glsl, azimuthal_glsl));
    p.Framed = true;
    return p;
  }();
  return framed;
}

const char* CommonGlsl()
{
  return common_glsl;
}

const char* DepthGlsl()
{
  return depth_glsl;
}

const char* MathGlsl()
{
  return glsl_math_glsl;
}
}
