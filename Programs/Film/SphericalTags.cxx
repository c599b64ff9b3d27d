// SPDX-License-Identifier: BSD-3-Clause
#include "SphericalTags.h"

#include "Options/StereoChoice.h"
#include "Options/StereoLayout.h"
#include "Pictures/GPano.h"
#include "Pictures/PictureFiles.h"
#include "Text/Messages.h"

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

// The shares of the whole sphere that are left out before and behind what is shown: 0.32 fixed
// point.
std::string Bounds(const SphericalInfo& info, int axis)
{
  const double seen = axis == 0 ? info.HorizontalFov / 360 : info.VerticalFov / 180;
  const int before = info.Before[axis];
  std::string bounds;
  for (const int pixels : { before, info.Whole[axis] - before - info.Eye[axis] })
  {
    const double share = std::max(0., 0.5 * (1 - seen) + seen * pixels / info.Whole[axis]);
    bounds += Mp4Number(static_cast<std::uint64_t>(std::floor(std::ldexp(share, 32))), 4);
  }
  return bounds;
}

Mp4Box StereoBox(const SphericalInfo& info)
{
  return FullBox("st3d", Mp4Number(info.StereoMode == "top-bottom" ? 1 : 2, 1));
}

Mp4Box SphericalBox(const SphericalInfo& info)
{
  // how players turn the sphere: 16.16 fixed point
  const auto pitch = static_cast<std::uint32_t>(std::lround(std::ldexp(info.Pitch, 16)));
  const Mp4Box header = FullBox("prhd", Mp4Number(0, 4) + Mp4Number(pitch, 4) + Mp4Number(0, 4));
  const Mp4Box equi = FullBox("equi", Bounds(info, 1) + Bounds(info, 0));
  return { "sv3d", "", { FullBox("svhd", Software + '\0'), { "proj", "", { header, equi } } } };
}

// Of --borders, in pixels of the frame, which may have the eyes squeezed.
void PlaceInWhole(const Options& o, SphericalInfo& info)
{
  info.Eye = { { info.StereoMode == "left-right" ? info.Width / 2 : info.Width,
    info.StereoMode == "top-bottom" ? info.Height / 2 : info.Height } };
  info.Whole = info.Eye;
  if (o.Part)
  {
    const PanoramaInfo drawn = DescribePanorama(o);
    for (int i = 0; i < 2; i++)
    {
      const double scale = double(info.Eye[i]) / o.Size[i];
      info.Whole[i] = static_cast<int>(std::lround(scale * drawn.Whole[i]));
      info.Before[i] = static_cast<int>(std::lround(scale * drawn.Before[i]));
    }
  }
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
    if (box.Type != "avcC" && box.Type != "hvcC" && box.Type != "vpcC" && box.Type != "av1C")
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
  PlaceInWhole(o, info);
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
  if (info.HorizontalFov < 360 || info.VerticalFov < 180 || info.Whole != info.Eye)
  {
    PanoramaInfo panorama;
    panorama.HorizontalFov = info.HorizontalFov;
    panorama.VerticalFov = info.VerticalFov;
    panorama.Whole = info.Whole;
    panorama.Before = info.Before;
    for (const wfvxmp::Field& field : CroppedFields(info.Eye[0], info.Eye[1], panorama))
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
