// SPDX-License-Identifier: BSD-3-Clause
// What there is: the files of the models compiled as C++, and one entry for each.
#include "Stereo/Stereo.h"

#include "Projections/NumberText.h"
#include "WideFoVGlsl.h"

#include <algorithm>
#include <cmath>

// A file may leave out what its family offers it, such as the view.
#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-parameter"
#endif
#define WFV_FADES true
#define WFV_TILTED true
#define float double
namespace wfv
{
namespace mono
{
#include "mono.glsl"
}
namespace offaxis
{
#include "offaxis.glsl"
}
namespace warped
{
#include "warped.glsl"
}
namespace omnidirectional
{
#include "omnidirectional.glsl"
}
}
#undef WFV_FADES
#undef WFV_TILTED
#undef float
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

namespace wfv
{
namespace
{
StereoParameters NoParameters(const StereoOptions&, const WfvView&)
{
  return {};
}

StereoParameters OffAxisParameters(const StereoOptions& o, const WfvView& v)
{
  return { o.Separation * o.Convergence / v.scale.x, vec4(o.Separation, 0, 0, 0) };
}

StereoParameters WarpedParameters(const StereoOptions& o, const WfvView&)
{
  return { 0.5 * o.Iod, vec4(o.Viewer[0], o.Viewer[1], o.Distance, o.Offset) };
}

StereoParameters OmnidirectionalParameters(const StereoOptions& o, const WfvView&)
{
  return { 0.5 * o.InterpupillaryDistance,
    vec4(glm::radians(o.PoleFade[0]), glm::radians(o.PoleFade[1]), 0, 0) };
}

double NoDepth(const WfvView&)
{
  return 0;
}

double DepthOfOffset(const WfvView& v)
{
  return v.stereo.w;
}

std::string CheckNothing(const StereoOptions&, const Projection&)
{
  return "";
}

std::string CheckOffAxis(const StereoOptions& o, const Projection& p)
{
  if (p.Axis != Family::Planar)
  {
    return "the stereo model offaxis is for the projection perspective, not for " + p.Name +
      "; omnidirectional and warped are for the others";
  }
  if (!(o.Separation >= 0) || !(o.Separation <= MostSeparation))
  {
    return "the separation must be in [0, " + NumberText(MostSeparation) + "] of the width, not " +
      NumberText(o.Separation);
  }
  return o.Convergence > 0 && std::isfinite(o.Convergence)
    ? ""
    : "the convergence must be above 0, not " + NumberText(o.Convergence);
}

// The models that change what the stages draw; a perspective goes without.
std::string CheckWide(const char* name, const Projection& p)
{
  return p.Axis != Family::Planar ? ""
                                  : "the stereo model " + std::string(name) +
      " is for wide projections; offaxis is for perspective";
}

std::string CheckWarped(const StereoOptions& o, const Projection& p)
{
  if (!(o.Iod >= 0) || !std::isfinite(o.Iod) || !std::isfinite(o.Distance) ||
    !(std::abs(o.Offset) <= 1))
  {
    return "warped stereo needs a finite iod of at least 0 and an offset in [-1, 1], not " +
      NumberText(o.Iod) + " and " + NumberText(o.Offset);
  }
  if (!std::isfinite(o.Viewer[0]) || !std::isfinite(o.Viewer[1]))
  {
    return "the viewer of warped stereo must be at a finite place";
  }
  if (!(o.Distance > 1 + o.Offset))
  {
    return "the distance of warped stereo must be above 1 + offset = " + NumberText(1 + o.Offset) +
      ", in front of the whole cube, not " + NumberText(o.Distance);
  }
  return CheckWide("warped", p);
}

std::string CheckOmnidirectional(const StereoOptions& o, const Projection& p)
{
  if (!(o.InterpupillaryDistance >= 0) || !std::isfinite(o.InterpupillaryDistance))
  {
    return "the interpupillary distance must be at least 0, not " +
      NumberText(o.InterpupillaryDistance);
  }
  const std::array<double, 2>& fade = o.PoleFade;
  if (!(fade[0] >= 0) || !(fade[1] >= fade[0]) || !(fade[1] <= 90))
  {
    return "the pole fade needs latitudes 0 <= A <= B <= 90, not " + NumberText(fade[0]) + " and " +
      NumberText(fade[1]);
  }
  if (!(o.CircleConvergence >= 0) || !std::isfinite(o.CircleConvergence))
  {
    return "the convergence must be at least 0, not " + NumberText(o.CircleConvergence);
  }
  return CheckWide("omnidirectional", p);
}

// A model that has no traits and numbers yet: the functions of one of the namespaces above.
#define WFV_STEREO(ns, name, title, source)                                                        \
  MakeModel(name, title, source, ns::wfvSee, ns::wfvEyeAt, ns::wfvShift, ns::wfvUnshift)

StereoModel MakeModel(const char* name, const char* title, const char* source,
  decltype(StereoModel::See) see, decltype(StereoModel::EyeAt) eyeAt,
  decltype(StereoModel::Shift) shift, decltype(StereoModel::Unshift) unshift)
{
  StereoModel m;
  m.Name = name;
  m.Title = title;
  m.Glsl = std::string(source);
  m.See = see;
  m.EyeAt = eyeAt;
  m.Shift = shift;
  m.Unshift = unshift;
  m.Parameters = NoParameters;
  m.DepthWithoutParallax = NoDepth;
  m.Check = CheckNothing;
  return m;
}

StereoModel MakeMono()
{
  StereoModel m = WFV_STEREO(mono, "mono", "No stereo", mono_glsl);
  m.Traits.TwoEyes = false;
  return m;
}

StereoModel MakeWarped()
{
  StereoModel m = WFV_STEREO(warped, "warped", "Warped volume", warped_glsl);
  m.Traits.StraightRays = false;
  m.Numbers = { StereoNumber::Iod, StereoNumber::Distance, StereoNumber::Offset,
    StereoNumber::Viewer };
  m.Parameters = WarpedParameters;
  m.DepthWithoutParallax = DepthOfOffset;
  m.Check = CheckWarped;
  return m;
}

StereoModel MakeOmnidirectional()
{
  StereoModel m =
    WFV_STEREO(omnidirectional, "omnidirectional", "Omnidirectional", omnidirectional_glsl);
  m.Traits.OneCenter = false;
  m.Numbers = { StereoNumber::InterpupillaryDistance, StereoNumber::PoleFade,
    StereoNumber::CircleConvergence };
  m.Parameters = OmnidirectionalParameters;
  m.FadesIn = omnidirectional::wfvFades;
  m.Check = CheckOmnidirectional;
  return m;
}

StereoModel MakeOffAxis()
{
  StereoModel m = WFV_STEREO(offaxis, "offaxis", "Off-axis", offaxis_glsl);
  m.Traits.Flat = true;
  m.Numbers = { StereoNumber::Separation, StereoNumber::Convergence };
  m.Parameters = OffAxisParameters;
  m.Check = CheckOffAxis;
  return m;
}
}

const std::vector<StereoModel>& StereoModels()
{
  static const std::vector<StereoModel> all{ MakeMono(), MakeWarped(), MakeOmnidirectional(),
    MakeOffAxis() };
  return all;
}

const StereoModel* FindStereoModel(const std::string& name)
{
  for (const StereoModel& m : StereoModels())
  {
    if (m.Name == name)
    {
      return &m;
    }
  }
  return nullptr;
}

double EyeTurn(const StereoOptions& o)
{
  const bool converges =
    o.Model && o.Model->Has(StereoNumber::CircleConvergence) && o.CircleConvergence > 0;
  const double sine = converges ? 0.5 * o.InterpupillaryDistance / o.CircleConvergence : 0;
  return SideOf(o.Eye) * std::asin(std::min(1.0, sine));
}

const StereoModel& NoStereo()
{
  return StereoModels().front();
}

const StereoModel& UsualStereo(const Projection& projection)
{
  return *FindStereoModel(projection.Axis == Family::Planar ? "offaxis" : "omnidirectional");
}

const StereoModel& StereoWith(StereoNumber number)
{
  const std::vector<StereoModel>& all = StereoModels();
  return *std::find_if(
    all.begin(), all.end(), [number](const StereoModel& m) { return m.Has(number); });
}
}
