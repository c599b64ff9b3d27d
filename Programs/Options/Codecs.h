// SPDX-License-Identifier: BSD-3-Clause
// Codecs and containers of films, as the program ffmpeg is told of them.
#ifndef WideFoVCodecs_h
#define WideFoVCodecs_h

#include "Film.h"

#include <string>
#include <vector>

namespace widefov
{
struct Codec
{
  std::string Name;                   // on the command line
  std::string Encoder;                // of ffmpeg
  std::string Segment;                // container of a part of a film: "mp4", "mov"
  std::vector<std::string> Arguments; // for the encoder
  bool HasQuality = true;             // takes a constant rate factor
  int MostQuality = 51;
};

struct Container
{
  std::string Ending;              // ".mp4"
  std::vector<std::string> Codecs; // names; the first is usual
  std::string Format;              // ffmpeg's name
  std::vector<std::string> Sound;  // arguments that encode sound
  bool IsMp4 = true;               // has boxes; else it is Matroska's family

  bool Takes(const std::string& codec) const;
};

// By the ending of a file; nullptr where it is no film's.
const Container* FindContainer(const std::string& path);

std::vector<std::string> VideoEndings();

// On the command line: "auto" and all codecs.
std::vector<std::string> CodecNames();

// What the options mean for that file.
std::string CodecNameFor(const FilmOptions& film, const std::string& output);

// The codec of a name, which must be one of a container's.
const Codec* FindCodec(const std::string& name); // never nullptr
}

#endif
