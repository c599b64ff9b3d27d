// SPDX-License-Identifier: BSD-3-Clause
// Compares a picture of cells with the double-precision ray caster's.
//
//   widefov-check-cells REQUEST.json
//
// The request: {"mesh": FILE.vtp, "picture": FILE.png, "projection", "hfov", "vfov", "tilt"
// (degrees), "eye", "focal", "up" (world), "clip": [near, far], "tolerance" (pixels)}, and of
// one of two eyes "stereo": {"model", "side" (-1 left, 1 right), "ipd", "fade", "warped",
// "separation", "convergence"}, the numbers as of vtkWideFoVCamera's setters. A
// pixel's colour is the number that the mesh's cell array "number" gives the cell, 24 bits,
// red the highest; black is nothing.
// The answer, on standard output: {"pixels", "hits", "mismatched", "unexplained",
// "missing", "spurious"} in pixels, {"max_px"} and "worst", the first few of them; and of what
// `auto` promises (HiddenFaces.h) "off", the pixels that show what is seen nowhere so near,
// "allowed", so many of them may be, and "broken", those that show what must not be shown there.
#include "CellFiles.h"
#include "HiddenFaces.h"
#include "Stereo/Stereo.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iostream>

using json = nlohmann::json;
using namespace wfv;

namespace
{
StereoOptions MakeStereo(const json& stereo)
{
  StereoOptions o;
  o.Model = FindStereoModel(stereo.at("model"));
  if (!o.Model)
  {
    throw std::runtime_error("unknown stereo model");
  }
  o.Eye = static_cast<Eye>(stereo.at("side").get<int>());
  o.InterpupillaryDistance = stereo.at("ipd");
  o.PoleFade = stereo.at("fade");
  const auto warped = stereo.at("warped").get<std::array<double, 3>>();
  o.Iod = warped[0];
  o.Distance = warped[1];
  o.Offset = warped[2];
  o.Separation = stereo.at("separation");
  o.Convergence = stereo.at("convergence");
  return o;
}

View MakeView(const json& request, double aspect)
{
  const Projection* const projection = FindProjection(request.at("projection"));
  if (!projection)
  {
    throw std::runtime_error("unknown projection");
  }
  ViewOptions o;
  // as far as the projection can show them, as in the view
  o.HorizontalFov = std::clamp(
    request.at("hfov").get<double>(), projection->MinHorizontalFov, projection->MaxHorizontalFov);
  o.VerticalFov = std::clamp(
    request.at("vfov").get<double>(), projection->MinVerticalFov, projection->MaxVerticalFov);
  o.Tilt = request.value("tilt", 0.0);
  o.Radii = request.at("clip");
  o.Aspect = aspect;
  if (request.contains("stereo"))
  {
    o.Stereo = MakeStereo(request.at("stereo"));
  }
  const std::string wrong = CheckOptions(*projection, o);
  if (!wrong.empty())
  {
    throw std::runtime_error(wrong);
  }
  return View(*projection, o);
}

json Describe(const reference::WorstPixel& pixel)
{
  return { { "x", pixel.I }, { "y", pixel.J }, { "drawn", pixel.Drawn },
    { "reference", pixel.Reference }, { "px", pixel.Pixels } };
}

// What `auto` promises of the picture.
json Judge(const reference::RayCaster& caster, int width, int height, const reference::Metrics& m,
  double tolerance)
{
  const long off = reference::CountOff(caster, width, height, m, tolerance);
  const long broken = std::count_if(m.Worst.begin(), m.Worst.end(), [&](const auto& pixel) {
    return !reference::MayShow(caster, width, height, pixel, tolerance);
  });
  // of more than are known, any may be
  const long unknown = m.UnexplainedPixels - long(m.Worst.size());
  return { { "off", off + unknown }, { "broken", broken + unknown },
    { "allowed", std::floor(reference::HiddenShare * width * height) } };
}

json Check(const json& request)
{
  const reference::DrawnPicture drawn = checkcells::ReadPicture(request.at("picture"));
  const View view = MakeView(request, static_cast<double>(drawn.Width) / drawn.Height);
  const reference::Pose pose =
    checkcells::MakePose(request.at("eye"), request.at("focal"), request.at("up"));
  const reference::RayCaster caster(checkcells::ReadSoup(request.at("mesh"), pose), view);
  const reference::HitPicture truth = caster.Render(drawn.Width, drawn.Height);
  // more mismatches than this are a broken picture, whose every pixel need not be searched
  const std::size_t mostSearched = truth.Hits.size() / 16;
  const double tolerance = request.at("tolerance");
  const reference::Metrics m = reference::Compare(drawn, caster, truth, tolerance, mostSearched);
  const double pixels = static_cast<double>(drawn.Width) * drawn.Height;
  json worst = json::array();
  for (std::size_t i = 0; i < std::min<std::size_t>(5, m.Worst.size()); i++)
  {
    worst.push_back(Describe(m.Worst[i]));
  }
  const long hits = std::count_if(
    truth.Hits.begin(), truth.Hits.end(), [](const reference::Hit& hit) { return hit.Cell >= 0; });
  json answer = { { "pixels", pixels }, { "hits", hits }, { "mismatched", m.Mismatched },
    { "unexplained", m.Unexplained * pixels }, { "missing", m.Missing * pixels },
    { "spurious", m.Spurious * pixels }, { "max_px", m.MaxPx }, { "worst", worst } };
  answer.update(Judge(caster, drawn.Width, drawn.Height, m, tolerance));
  return answer;
}
}

int main(int argc, char* argv[])
{
  if (argc != 2)
  {
    std::cerr << "widefov-check-cells: name the request\n";
    return 2;
  }
  try
  {
    std::ifstream in(argv[1]);
    std::cout << Check(json::parse(in)) << std::endl;
  }
  catch (const std::exception& e)
  {
    std::cerr << "widefov-check-cells: " << e.what() << "\n";
    return 1;
  }
  return 0;
}
