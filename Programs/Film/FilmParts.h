// SPDX-License-Identifier: BSD-3-Clause
// The folder of a film that is not whole yet: encoded runs of frames, which later runs of the
// program, or others at the same time, add to.
#ifndef WideFoVFilmParts_h
#define WideFoVFilmParts_h

#include "FilmSink.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace widefov
{
// A file that only one process has open at a time; it goes with the object.
class LockedFile
{
public:
  // Waits for others, or does not. Throws a Failure with ExitFailed where there can be no file.
  LockedFile(const std::string& path, bool wait);
  ~LockedFile();
  LockedFile(const LockedFile&) = delete;
  LockedFile& operator=(const LockedFile&) = delete;

  bool IsMine() const { return this->File >= 0; }

private:
  std::string Path;
  int File = -1;
};

class FilmParts
{
public:
  // Makes the folder film.mp4.parts, or goes on in it. `segment` is the ending of its runs. Throws
  // a Failure with ExitFailed: frames are there and neither --resume nor --part is given, they are
  // another film's, or another process draws the same part.
  FilmParts(const std::string& film, const std::string& segment, const FilmOptions& options,
    const FilmPlan& plan);
  ~FilmParts();
  FilmParts(const FilmParts&) = delete;
  FilmParts& operator=(const FilmParts&) = delete;

  // Where the frames of a film wait; it is there until the film is whole.
  static std::string FolderOf(const std::string& film) { return film + ".parts"; }

  // The frame was there when this was made.
  bool Has(int frame) const { return this->Present[static_cast<std::size_t>(frame)]; }

  // A file of the folder, for what is under way in this process alone.
  std::string Scratch(const std::string& name) const;

  // A run of frames is whole: its file gets its name. Throws a Failure with ExitFailed.
  void Add(const std::string& scratch, int first, int last);

  // Processes do it one after the other: where all frames are there, `join` gets a list of their
  // files for ffmpeg, and the folder goes. Where some are missing, a line says so.
  void JoinWhole(const std::function<void(const std::string& list)>& join);

private:
  struct Run
  {
    int First;
    int Last;
    std::string Name;
  };

  void Claim(const FilmOptions& options);
  void RemoveScratch() const;
  void CheckSameFilm(const std::string& command) const;
  std::vector<Run> FindRuns() const;
  std::string WriteList() const;

  std::string Film;
  std::string Folder;
  std::string Segment;
  std::string Own; // begins the names of this part's own files
  FilmPlan Plan;
  std::vector<bool> Present;
  std::optional<LockedFile> Lock;
};
}

#endif
