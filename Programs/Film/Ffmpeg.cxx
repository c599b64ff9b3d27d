// SPDX-License-Identifier: BSD-3-Clause
#include "Ffmpeg.h"

#include "Text/Messages.h"

#include <filesystem>

namespace widefov
{
namespace
{
using Words = std::vector<std::string>;

Words Joined(std::initializer_list<Words> parts)
{
  Words all;
  for (const Words& part : parts)
  {
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}

// Without its questions, banners and counters.
const Words Silent{ "ffmpeg", "-hide_banner", "-nostdin", "-loglevel", "error", "-y" };

// ffmpeg takes "a:b" for a protocol and "-a" for an option.
std::string AsFile(const std::string& path)
{
  return "file:" + path;
}

std::string PixelsOf(const Codec& codec)
{
  return codec.Name == "prores" ? "yuv422p10le" : "yuv420p";
}

// Apple's players want this word.
Words TagOf(const Codec& codec)
{
  return codec.Name == "x265" ? Words{ "-tag:v", "hvc1" } : Words{};
}

// Names of the encoders stand in the second column.
bool HasEncoder(const std::string& list, const std::string& encoder)
{
  return list.find(" " + encoder + " ") != std::string::npos;
}

void CheckAudio(const std::string& audio)
{
  std::error_code error;
  if (!std::filesystem::is_regular_file(audio, error))
  {
    Fail("--audio: " + audio + " is not there, or no file; check the name");
  }
  bool well = false;
  const auto tried = RunToEnd(
    Joined({ Silent, { "-i", AsFile(audio), "-map", "0:a:0", "-t", "0.1", "-f", "null", "-" } }),
    well);
  if (!well)
  {
    Fail("--audio: " + audio + " has no sound that ffmpeg can read: " + tried->GetComplaint() +
      "; choose another file");
  }
}
}

void CheckFfmpeg(const Options& o)
{
  std::string encoders;
  for (const std::string& output : o.Outputs)
  {
    if (FindContainer(output) == nullptr)
    {
      continue;
    }
    if (encoders.empty())
    {
      bool well = false;
      encoders = RunToEnd({ "ffmpeg", "-hide_banner", "-encoders" }, well)->GetOutput();
    }
    const Codec& codec = *FindCodec(CodecNameFor(o.Film, output));
    if (!HasEncoder(encoders, codec.Encoder))
    {
      Fail(output + ": the ffmpeg that is installed cannot encode " + codec.Name + " (no " +
        codec.Encoder + "); choose another --codec, or write frames/%05d.png");
    }
  }
  if (!o.Film.Audio.empty())
  {
    CheckAudio(o.Film.Audio);
  }
}

std::vector<std::string> EncodeCommand(const FilmOptions& film, const Codec& codec,
  const std::array<int, 2>& size, const std::string& file)
{
  const std::string pixels = std::to_string(size[0]) + "x" + std::to_string(size[1]);
  // ProRes takes its colour tags from the frames, the other encoders from the options
  const std::string color = "scale=out_color_matrix=bt709:out_range=tv:flags=accurate_rnd+full_"
                            "chroma_int,setparams=range=tv:"
                            "color_primaries=bt709:color_trc=bt709:colorspace=bt709,format=" +
    PixelsOf(codec);
  const Words quality = film.Quality < 0 ? Words{} : Words{ "-crf", std::to_string(film.Quality) };
  return Joined({ { "ffmpeg", "-hide_banner", "-loglevel", "error", "-y" },
    { "-f", "rawvideo", "-pixel_format", "rgb24", "-video_size", pixels },
    { "-framerate", film.FpsText, "-i", "-", "-vf", color, "-c:v", codec.Encoder }, codec.Arguments,
    quality, { "-colorspace", "bt709", "-color_primaries", "bt709", "-color_trc", "bt709" },
    { "-color_range", "tv", "-f", codec.Segment, AsFile(file) } });
}

std::vector<std::string> JoinCommand(
  const std::string& list, const Codec& codec, const std::string& file)
{
  return Joined(
    { Silent, { "-f", "concat", "-safe", "0", "-i", AsFile(list), "-map", "0:v:0", "-c", "copy" },
      TagOf(codec), { "-f", codec.Segment, AsFile(file) } });
}

std::vector<std::string> MuxCommand(const std::string& joined, const Container& container,
  const Codec& codec, const Muxing& muxing, const std::string& file)
{
  Words input;
  Words sound;
  if (!muxing.Audio.empty())
  {
    input = { "-i", AsFile(muxing.Audio) };
    sound =
      Joined({ { "-map", "1:a:0" }, container.Sound, { "-t", std::to_string(muxing.Seconds) } });
  }
  Words metadata;
  if (!muxing.StereoMode.empty())
  {
    metadata = { "-metadata:s:v:0", "stereo_mode=" + muxing.StereoMode };
  }
  if (!muxing.Spherical.empty())
  {
    metadata = Joined({ metadata, { "-metadata:s:v:0", "SPHERICAL-VIDEO=" + muxing.Spherical } });
  }
  return Joined({ Silent, { "-i", AsFile(joined) }, input, { "-map", "0:v:0", "-c:v", "copy" },
    container.IsMp4 ? TagOf(codec) : Words{}, sound, metadata,
    { "-f", container.Format, AsFile(file) } });
}

bool FinishFfmpeg(ChildProcess& process)
{
  const bool well = process.Finish();
  const auto said = [&process](const char* words) {
    return process.GetErrors().find(words) != std::string::npos;
  };
  return well && !said("Error writing trailer") && !said("Error closing file");
}

void RunFfmpeg(const std::vector<std::string>& command, const std::string& file)
{
  ChildProcess process(command);
  if (!FinishFfmpeg(process))
  {
    Fail(file + " cannot be written: " + process.GetComplaint() +
      "; make room, or choose another place");
  }
}
}
