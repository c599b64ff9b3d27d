// SPDX-License-Identifier: BSD-3-Clause
#include "Record.h"

#include "Text/Messages.h"

#include <algorithm>
#include <cmath>

namespace wfv
{
namespace bench
{
namespace
{
Json Times(const std::vector<double>& ms)
{
  if (ms.empty())
  {
    return { { "median", nullptr }, { "min", nullptr }, { "max", nullptr } };
  }
  const widefov::Spread s = widefov::SpreadOf(ms);
  return { { "median", s.Median }, { "min", s.Least }, { "max", s.Most } };
}

// A distance that the search did not find within its limit counts as that limit.
double Found(double pixels)
{
  return std::min(pixels, reference::SearchLimit);
}

// Where to look, rows from the top, and how far behind the true cell the drawn one lies.
Json Places(const std::vector<reference::WorstPixel>& pixels)
{
  Json places = Json::array();
  for (const reference::WorstPixel& p : pixels)
  {
    const bool both = p.Drawn >= 0 && p.Reference >= 0;
    places.push_back({ { "pixel", { p.I, p.J } }, { "drawn", p.Drawn },
      { "reference", p.Reference }, { "px", Found(p.Pixels) },
      { "behind", both ? Json(p.DrawnDistance - p.ReferenceDistance) : Json(nullptr) } });
  }
  return places;
}

Json Figures(const std::optional<ErrorFigures>& error)
{
  if (!error)
  {
    return nullptr;
  }
  const reference::Metrics& m = error->Metrics;
  const bool depth = error->HasDepth && std::isfinite(m.MaxDepthRel);
  return { { "unexplained", m.Unexplained }, { "missing", m.Missing }, { "spurious", m.Spurious },
    { "max_px", Found(m.MaxPx) }, { "p99_px", Found(m.P99Px) },
    { "max_depth_rel", depth ? Json(m.MaxDepthRel) : Json(nullptr) },
    { "depth_px", depth && std::isfinite(m.DepthPx) ? Json(m.DepthPx) : Json(nullptr) },
    { "depth_ulps", depth && std::isfinite(m.DepthUlps) ? Json(m.DepthUlps) : Json(nullptr) },
    { "b", error->Tolerance }, { "mismatched_pixels", m.Mismatched },
    { "searched_pixels", m.Searched }, { "tie_pixels", m.Ties }, { "places", Places(m.Worst) } };
}
}

std::optional<double> MedianOf(const Record& record)
{
  return record.Milliseconds.empty()
    ? std::nullopt
    : std::optional<double>(widefov::SpreadOf(record.Milliseconds).Median);
}

std::string NameOf(const Run& run)
{
  return run.Method + (run.Parameter ? "_" + widefov::Text(*run.Parameter) : "");
}

Json ToJson(const Record& r)
{
  const widefov::Options& o = r.Run.Options;
  const bool floor = r.Run.Method == "floor"; // a parallel camera has no field of view
  Json json = { { "scene", r.Scene }, { "triangles", r.Triangles },
    { "projection", floor ? "parallel" : o.Projection },
    { "hfov", floor ? Json(nullptr) : Json(o.View.HorizontalFov) },
    { "vfov", floor ? Json(nullptr) : Json(o.View.VerticalFov) },
    { "size", { o.Size[0], o.Size[1] } }, { "samples", o.Samples },
    { "mode", NameOf(r.Run.Motion.Mode) }, { "method", r.Run.Method },
    { "parameter", r.Run.Parameter ? Json(*r.Run.Parameter) : Json(nullptr) },
    { "ms", Times(r.Milliseconds) }, { "processor_ms", Times(r.ProcessorMilliseconds) },
    { "frames", r.Milliseconds.size() },
    { "first_ms", r.FirstMilliseconds ? Json(*r.FirstMilliseconds) : Json(nullptr) },
    { "covered", r.Covered ? Json(*r.Covered) : Json(nullptr) },
    { "fragments", r.Fragments ? Json(*r.Fragments) : Json(nullptr) },
    { "error", Figures(r.Error) } };
  if (!r.Run.DirectionsOf.empty())
  {
    json["directions_of"] = r.Run.DirectionsOf;
  }
  if (r.Run.Motion.Mode == Mode::Turn)
  {
    json["turn"] = r.Run.Motion.Degrees;
  }
  if (!r.Note.empty())
  {
    json["note"] = r.Note;
  }
  return json;
}
}
}
