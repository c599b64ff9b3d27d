// SPDX-License-Identifier: BSD-3-Clause
// Sources of the sizes: the dome master of planetariums is square, the whole fisheye in it, its top
// in the middle; players of panoramas take 2:1 an eye, video sites up to 8192 pixels across; A2 is
// 594 mm across, here at 300 pixels an inch.
#include "Presets/Presets.h"

#include <algorithm>

namespace wfv
{
namespace
{
Preset Dome(const std::string& size, int pixels)
{
  return { "domemaster-" + size, "dome master, " + std::to_string(pixels) + " pixels across",
    size == "4k" ? "Planetarium dome" : "", "azimuthal-equidistant", 180, 180, 90,
    { { pixels, pixels } }, false, "", "prores" };
}

Preset Sphere(const std::string& name, const std::string& title, const std::string& viewTitle,
  int width, const std::string& codec)
{
  return { name, title, viewTitle, "equirectangular", 360, 180, 0, { { width, width / 2 } }, false,
    "", codec };
}

Preset WithEyes(Preset preset, const std::string& layout)
{
  preset.TwoEyes = true;
  preset.Layout = layout;
  return preset;
}

Preset Half(const std::string& name, const std::string& title, const std::string& viewTitle)
{
  return { name, title, viewTitle, "equirectangular", 180, 180, 0, { { 2880, 2880 } }, false, "",
    "x265" };
}

Preset Named(
  Preset preset, const std::string& name, const std::string& title, const std::string& viewTitle)
{
  preset.Name = name;
  preset.Title = title;
  preset.ViewTitle = viewTitle;
  return preset;
}
}

const std::vector<Preset>& Presets()
{
  static const std::vector<Preset> all{
    Sphere("360-photo", "panorama of all directions", "360 photo", 8192, ""),
    Sphere("360-video", "film of all directions", "", 3840, "x264"),
    WithEyes(Sphere("360-stereo-photo", "panorama for two eyes", "", 8192, ""), "top-bottom"),
    WithEyes(Sphere("360-stereo-video", "film of all directions for two eyes", "360 stereo video",
               3840, "x265"),
      "top-bottom"),
    Sphere("youtube-8k", "film of all directions, the largest of video sites", "", 7680, "vp9"),
    WithEyes(Half("vr180", "half a sphere for two eyes", "VR180"), "vr180"),
    Half("vr180-mono", "half a sphere for one eye", "VR180, one eye"),
    Dome("1k", 1024),
    Dome("2k", 2048),
    Dome("4k", 4096),
    Dome("8k", 8192),
    WithEyes(Named(Dome("4k", 4096), "planetarium-stereo", "dome masters for two eyes, a file each",
               "Planetarium dome, two eyes"),
      "separate"),
    { "fisheye", "fisheye of half a sphere, straight ahead", "Fisheye", "azimuthal-equidistant",
      180, 180, 0, { { 2048, 2048 } }, false, "", "x264" },
    { "little-planet", "planet of all but the sky", "", "stereographic", 300, 300, -90,
      { { 4096, 4096 } }, false, "", "" },
    { "hammer-print", "map of all directions that keeps areas, A2 at 300 pixels an inch",
      "Whole sphere, equal areas", "hammer", 360, 180, 0, { { 7016, 3508 } }, false, "", "" },
  };
  return all;
}

const Preset* FindPreset(const std::string& name)
{
  const auto found = std::find_if(
    Presets().begin(), Presets().end(), [&name](const Preset& p) { return p.Name == name; });
  return found == Presets().end() ? nullptr : &*found;
}
}
