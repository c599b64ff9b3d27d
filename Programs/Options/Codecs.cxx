// SPDX-License-Identifier: BSD-3-Clause
#include "Codecs.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <stdexcept>

namespace widefov
{
namespace
{
const std::vector<Codec>& Codecs()
{
  // qualities at which a picture of thin lines on black looks as it was drawn
  static const std::vector<Codec> all{
    { "x264", "libx264", "mp4", { "-preset", "medium", "-crf", "18" } },
    { "x265", "libx265", "mp4",
      { "-preset", "medium", "-crf", "20", "-x265-params", "log-level=error" } },
    { "vp9", "libvpx-vp9", "mp4",
      { "-deadline", "good", "-cpu-used", "4", "-row-mt", "1", "-b:v", "0", "-crf", "24" }, true,
      63 },
    { "av1", "libaom-av1", "mp4", { "-cpu-used", "6", "-row-mt", "1", "-b:v", "0", "-crf", "24" },
      true, 63 },
    { "prores", "prores_ks", "mov", { "-profile:v", "3", "-vendor", "apl0" }, false },
  };
  return all;
}

const std::vector<Container>& Containers()
{
  const std::vector<std::string> aac{ "-c:a", "aac", "-b:a", "256k" };
  const std::vector<std::string> opus{ "-c:a", "libopus", "-b:a", "192k" };
  static const std::vector<Container> all{
    { ".mp4", { "x264", "x265", "vp9", "av1" }, "mp4", aac },
    { ".mov", { "prores", "x264", "x265" }, "mov", aac },
    { ".webm", { "vp9", "av1" }, "webm", opus, false },
    { ".mkv", { "x264", "x265", "vp9", "av1", "prores" }, "matroska", aac, false },
  };
  return all;
}
}

bool Container::Takes(const std::string& codec) const
{
  return std::find(this->Codecs.begin(), this->Codecs.end(), codec) != this->Codecs.end();
}

const Container* FindContainer(const std::string& path)
{
  std::string ending = std::filesystem::path(path).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  for (const Container& container : Containers())
  {
    if (container.Ending == ending)
    {
      return &container;
    }
  }
  return nullptr;
}

std::vector<std::string> VideoEndings()
{
  std::vector<std::string> endings;
  for (const Container& container : Containers())
  {
    endings.push_back(container.Ending);
  }
  return endings;
}

std::vector<std::string> CodecNames()
{
  std::vector<std::string> names{ "auto" };
  for (const Codec& codec : Codecs())
  {
    names.push_back(codec.Name);
  }
  return names;
}

std::string CodecNameFor(const FilmOptions& film, const std::string& output)
{
  if (film.Codec != "auto")
  {
    return film.Codec;
  }
  const Container& container = *FindContainer(output);
  return container.Takes(film.PresetCodec) ? film.PresetCodec : container.Codecs.front();
}

const Codec* FindCodec(const std::string& name)
{
  for (const Codec& codec : Codecs())
  {
    if (codec.Name == name)
    {
      return &codec;
    }
  }
  throw std::logic_error("no codec is named " + name);
}
}
