// SPDX-License-Identifier: BSD-3-Clause
// What the command line says of a film, as plain values.
#ifndef WideFoVFilm_h
#define WideFoVFilm_h

#include <string>
#include <vector>

namespace widefov
{
struct FilmOptions
{
  std::string Kind;           // how the camera moves; empty: pictures, no film
  double Seconds = 0;         // 0: ten, or a frame for each time step
  double Fps = 25;            // frames a second
  std::string FpsText = "25"; // the same as it was given: 30000/1001
  std::string Codec = "auto"; // the preset's where the file can hold it, or by the file's ending
  std::string PresetCodec;    // of --preset; empty: it has none
  int Quality = -1;           // constant rate factor; -1: the codec's own
  std::string Audio;          // file of sound
  std::string Path;           // file of poses
  double Sweep = 360;         // degrees of a turn or an orbit
  std::string Ease = "auto";  // smooth where the film does not end as it begins
  bool Resume = false;        // keeps the frames that are there
  bool Strict = false;        // a broken time step ends the film
  int Part = 1;               // of Parts: what this process draws
  int Parts = 1;
  std::vector<std::string> Given; // options on the command line that only films have
  std::string Command;            // tells the film from others (FilmIdentity.h)
};
}

#endif
