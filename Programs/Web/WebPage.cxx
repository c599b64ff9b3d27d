// SPDX-License-Identifier: BSD-3-Clause
#include "WebPage.h"

#include "BarPicture.h"
#include "PageFiles.h"
#include "PictureTiles.h"
#include "Pictures/GPano.h"
#include "Pictures/ImageOutput.h"
#include "Pictures/PictureFiles.h"
#include "System/Progress.h"
#include "Text/Messages.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>

namespace widefov
{
namespace
{
using Json = nlohmann::ordered_json;

// Pixels across: browsers show no larger picture at once.
constexpr int LargestAtOnce = 8192;

// Pixels across the picture that is seen before the tiles come, and in a headset.
constexpr int FirstWidth = 4096;

std::string TitleOf(const Options& o)
{
  if (!o.Title.empty())
  {
    return o.Title;
  }
  return o.Files.empty() ? o.Scene : std::filesystem::path(o.Files.front()).stem().string();
}

// The part of the sphere that a picture shows, by the viewer's names.
Json SphereOf(const Options& o, int width, int height)
{
  Json sphere;
  const std::pair<const char*, const char*> names[] = { { "FullPanoWidthPixels", "fullWidth" },
    { "FullPanoHeightPixels", "fullHeight" }, { "CroppedAreaImageWidthPixels", "croppedWidth" },
    { "CroppedAreaImageHeightPixels", "croppedHeight" }, { "CroppedAreaLeftPixels", "croppedX" },
    { "CroppedAreaTopPixels", "croppedY" }, { "PosePitchDegrees", "posePitch" } };
  for (const wfvxmp::Field& field : GPanoFields(width, height, DescribePanorama(o)))
  {
    for (const auto& [name, key] : names)
    {
      if (field.Name == name)
      {
        sphere[key] = std::stod(field.Value);
      }
    }
  }
  return sphere;
}

void AddPicture(PageFiles& files, const std::string& name, const Picture& picture,
  const PanoramaInfo& info = PanoramaInfo())
{
  files.AddWithTwin(name, EncodePicture(picture, name, info));
}

void AddBar(PageFiles& files, const Options& o, const Scene& scene, Json& page)
{
  const std::optional<Picture> bar = o.ScalarBarAt.empty() ? DrawBar(scene) : std::nullopt;
  if (bar)
  {
    AddPicture(files, "bar.png", *bar);
    page["bar"] = "bar.png";
  }
}

void Finish(PageFiles& files, const Options& o, const Json& page)
{
  const std::string text =
    "widefov.show(" + page.dump(2, ' ', false, Json::error_handler_t::replace) + ");\n";
  files.Add("page.js", text.data(), text.size());
  files.Commit();
  Tell("written: " + o.Web + "/index.html");
}

Json AddTiles(PageFiles& files, const Picture& picture)
{
  Progress progress("writing tiles");
  const std::vector<TileLevel> levels = PlanLevels(picture.Width);
  Json sizes = Json::array();
  for (std::size_t i = 0; i < levels.size(); i++)
  {
    const TileLevel& level = levels[i];
    const Picture scaled = Scale(picture, level.Width, level.Width / 2);
    for (int row = 0; row < level.Columns / 2; row++)
    {
      for (int column = 0; column < level.Columns; column++)
      {
        const std::string name = "tiles/" + std::to_string(i) + "-" + std::to_string(column) + "-" +
          std::to_string(row) + ".jpg";
        AddPicture(files, name, CutTile(scaled, level, column, row));
      }
    }
    sizes.push_back({ { "width", level.Width }, { "columns", level.Columns } });
    progress.Update((i + 1.0) / levels.size());
  }
  return sizes;
}

// As large as browsers show it at once.
Picture Reduce(const Picture& picture, int width)
{
  return Scale(
    picture, width, static_cast<int>(std::lround(double(width) * picture.Height / picture.Width)));
}

bool IsWholeSphere(const Options& o)
{
  return !o.Part && o.View.HorizontalFov == 360 && o.View.VerticalFov == 180;
}

// Name of the file of an eye: NAME, or NAME-right of the right eye.
std::string NameOfEye(std::size_t eye)
{
  return eye == 0 ? "panorama.jpg" : "panorama-right.jpg";
}
}

void CheckWebPage(const Options& o)
{
  ViewerFolder();
  CheckPageFolder(o.Web);
}

void WritePicturePage(const Options& o, const Scene& scene, const std::vector<Picture>& eyes)
{
  PageFiles files(o.Web);
  Json page{ { "title", TitleOf(o) } };
  const bool large = eyes[0].Width > LargestAtOnce;
  const bool tiled = large && IsWholeSphere(o);
  if (tiled)
  {
    page["tiles"] = AddTiles(files, eyes[0]);
  }
  else if (large)
  {
    Say("warning: the picture of the web page is " + std::to_string(LargestAtOnce) +
      " pixels wide; only a whole sphere has tiles");
  }
  const int width = tiled ? FirstWidth : std::min(eyes[0].Width, LargestAtOnce);
  for (std::size_t i = 0; i < eyes.size(); i++)
  {
    const Picture shown = Reduce(eyes[i], width);
    AddPicture(files, NameOfEye(i), shown, DescribePanorama(o));
    page[i == 0 ? "picture" : "right"] = NameOfEye(i);
    page["sphere"] = SphereOf(o, shown.Width, shown.Height);
  }
  AddBar(files, o, scene, page);
  Finish(files, o, page);
}

void WriteFilmPage(const Options& o, const Scene& scene)
{
  std::error_code error;
  if (!std::filesystem::exists(o.Web + "/" + WebFilm, error))
  {
    return;
  }
  PageFiles files(o.Web);
  Json page{ { "title", TitleOf(o) }, { "film", WebFilm },
    { "sphere", SphereOf(o, o.Size[0], o.Size[1]) } };
  if (!files.AddTwin(WebFilm))
  {
    Say("warning: the film in " + o.Web +
      " plays from a web server alone: it is too large for a page "
      "that is opened as a file");
  }
  AddBar(files, o, scene, page);
  Finish(files, o, page);
}
}
