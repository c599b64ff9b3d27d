// SPDX-License-Identifier: BSD-3-Clause
// The program ffmpeg: is it there, and how it is asked for films.
#ifndef WideFoVFfmpeg_h
#define WideFoVFfmpeg_h

#include "Options/Codecs.h"
#include "Options/Options.h"
#include "System/ChildProcess.h"

#include <array>
#include <string>
#include <vector>

namespace widefov
{
// Throws a Failure with ExitFailed where a film that the options ask for cannot be made here: no
// ffmpeg, no encoder, no sound in the file of sound.
void CheckFfmpeg(const Options& options);

// Encodes rows of red, green, blue from standard input into a part of a film.
std::vector<std::string> EncodeCommand(const FilmOptions& film, const Codec& codec,
  const std::array<int, 2>& size, const std::string& file);

// Joins the parts that a list names; nothing is encoded again.
std::vector<std::string> JoinCommand(
  const std::string& list, const Codec& codec, const std::string& file);

// What goes into the last file besides the picture.
struct Muxing
{
  std::string Audio;      // file; empty: none
  double Seconds = 0;     // length of the film
  std::string StereoMode; // Matroska's word for the layout; empty: none
  std::string Spherical;  // metadata of spherical video, version 1; empty: none
};

// From the joined film to the container's.
std::vector<std::string> MuxCommand(const std::string& joined, const Container& container,
  const Codec& codec, const Muxing& muxing, const std::string& file);

// Closes its input and waits; true where its file is whole. Some versions end well although the
// disk was full when they wrote the end of the file.
bool FinishFfmpeg(ChildProcess& process);

// Runs ffmpeg. Throws a Failure with ExitFailed that names the file and what ffmpeg said.
void RunFfmpeg(const std::vector<std::string>& command, const std::string& file);
}

#endif
