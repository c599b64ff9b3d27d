// SPDX-License-Identifier: BSD-3-Clause
#include "SphericalTags.h"

#include "GPano.h"
#include "Messages.h"
#include "PictureFiles.h"
#include "StereoChoice.h"
#include "StereoLayout.h"
#include "StereoOptions.h"

#include <algorithm>
#include <cmath>

namespace widefov
{
namespace
{
constexpr std::size_t EntryFields = 78; // of a visual sample entry, before its boxes

// Of the box uuid that holds version 1.
const std::string Version1Id = std::string("\xff\xcc\x82\x63\xf8\x55\x4a\x93"
                                           "\x88\x14\x58\x7a\x02\x52\x1f\xdd",
  16);

const std::string Software = "VTKWideFoV";

std::string Element(const std::string& name, const std::string& value)
{
  return "<GSpherical:" + name + ">" + value + "</GSpherical:" + name + ">";
}

// A box with version 0 and flags 0.
Mp4Box FullBox(const std::string& type, const std::string& fields)
{
  return { type, Mp4Number(0, 4) + fields, {} };
}

// The share of the whole that is left out on each of two sides: 0.32 fixed point.
std::string Bound(double fov, double whole)
{
  const double share = std::max(0., 0.5 * (1 - fov / whole));
  return Mp4Number(static_cast<std::uint64_t>(std::floor(std::ldexp(share, 32))), 4);
}

Mp4Box StereoBox(const SphericalInfo& info)
{
  return FullBox("st3d", Mp4Number(info.StereoMode == "top-bottom" ? 1 : 2, 1));
}

Mp4Box SphericalBox(const SphericalInfo& info)
{
  const std::string rows = Bound(info.VerticalFov, 180);
  const std::string columns = Bound(info.HorizontalFov, 360);
  // how players turn the sphere: 16.16 fixed point
  const auto pitch = static_cast<std::uint32_t>(std::lround(std::ldexp(info.Pitch, 16)));
  const Mp4Box header = FullBox("prhd", Mp4Number(0, 4) + Mp4Number(pitch, 4) + Mp4Number(0, 4));
  const Mp4Box equi = FullBox("equi", rows + rows + columns + columns);
  return { "sv3d", "", { FullBox("svhd", Software + '\0'), { "proj", "", { header, equi } } } };
}

// Behind the codec's own box, and before those that may be missing.
std::size_t PlaceInEntry(const Mp4Box& entry)
{
  if (entry.Fields.size() < EntryFields)
  {
    Fail("the video that ffmpeg wrote has no description; choose another ending");
  }
  const std::vector<Mp4Box> boxes = ParseBoxes(entry.Fields.substr(EntryFields));
  std::size_t place = EntryFields;
  for (const Mp4Box& box : boxes)
  {
    if (box.Type != "avcC" && box.Type != "hvcC" && box.Type != "vpcC")
    {
      break;
    }
    place += BoxBytes(box).size();
  }
  return place;
}
}

SphericalInfo DescribeFilm(const Options& o)
{
  const StereoLayout& layout = FindStereoLayout(o.Layout);
  const std::array<int, 2> size = SizeOfFile(o);
  SphericalInfo info;
  info.Width = size[0];
  info.Height = size[1];
  info.HorizontalFov = o.View.HorizontalFov;
  info.VerticalFov = o.View.VerticalFov;
  info.Pitch = o.View.Tilt;
  const bool two = HasTwoEyes(o) && layout.Columns * layout.Rows == 2;
  if (two)
  {
    info.StereoMode = layout.Columns == 2 ? "left-right" : "top-bottom";
  }
  const double steepest = 90; // beyond, the view stands on its head, which players do not know
  info.Equirectangular = o.Projection == "equirectangular" && std::abs(info.Pitch) <= steepest &&
    (!HasTwoEyes(o) || (!ShowsCube(o) && (two || layout.IsOneEye())));
  return info;
}

std::string SphericalXml(const SphericalInfo& info)
{
  if (!info.Equirectangular)
  {
    return "";
  }
  std::string text = "<rdf:SphericalVideo"
                     " xmlns:rdf=\"http://www.w3.org/1999/02/22-rdf-syntax-ns#\""
                     " xmlns:GSpherical=\"http://ns.google.com/videos/1.0/spherical/\">" +
    Element("Spherical", "true") + Element("Stitched", "true") +
    Element("StitchingSoftware", Software) + Element("ProjectionType", "equirectangular");
  if (!info.StereoMode.empty())
  {
    text += Element("StereoMode", info.StereoMode);
  }
  if (info.HorizontalFov < 360 || info.VerticalFov < 180)
  {
    PanoramaInfo panorama;
    panorama.HorizontalFov = info.HorizontalFov;
    panorama.VerticalFov = info.VerticalFov;
    const int width = info.StereoMode == "left-right" ? info.Width / 2 : info.Width;
    const int height = info.StereoMode == "top-bottom" ? info.Height / 2 : info.Height;
    for (const wfvxmp::Field& field : CroppedFields(width, height, panorama))
    {
      text += Element(field.Name, field.Value);
    }
  }
  return "<?xml version=\"1.0\"?>" + text + "</rdf:SphericalVideo>";
}

std::string MatroskaStereoMode(const SphericalInfo& info)
{
  return info.StereoMode == "top-bottom" ? "top_bottom"
    : info.StereoMode == "left-right"    ? "left_right"
                                         : "";
}

void TagMovie(Mp4Box& movie, const SphericalInfo& info)
{
  const VideoTrack video = FindVideoTrack(movie);
  if (video.Entry == nullptr)
  {
    Fail("the film that ffmpeg wrote has no video; choose another ending");
  }
  std::string boxes;
  if (!info.StereoMode.empty())
  {
    boxes += BoxBytes(StereoBox(info));
  }
  if (info.Equirectangular)
  {
    boxes += BoxBytes(SphericalBox(info));
  }
  video.Entry->Fields.insert(PlaceInEntry(*video.Entry), boxes);
  if (info.Equirectangular)
  {
    video.Track->Children.push_back({ "uuid", Version1Id + SphericalXml(info), {} });
  }
}
}
