// SPDX-License-Identifier: BSD-3-Clause
// Where the frames of a film go.
#ifndef WideFoVFilmSink_h
#define WideFoVFilmSink_h

#include "Options/Options.h"
#include "Pictures/ImageOutput.h"

#include <memory>
#include <string>
#include <vector>

namespace widefov
{
struct FilmFrame
{
  int Number = 0;             // from 0
  std::vector<Picture> Drawn; // one, or one of each eye
};

// What a film is, for those who write it.
struct FilmPlan
{
  int Frames = 0; // of all parts
  int First = 0;  // of this part
  int End = 0;    // behind its last one
};

class FilmSink
{
public:
  FilmSink() = default;
  virtual ~FilmSink() = default;
  FilmSink(const FilmSink&) = delete;
  FilmSink& operator=(const FilmSink&) = delete;

  // The frame was there when this was made.
  virtual bool Has(int frame) const = 0;

  // Frames come in their order. Throws a Failure with ExitFailed where the disk is full or the
  // encoder ends.
  virtual void Add(const FilmFrame& frame) = 0;

  // Ends before the last frame; those that were added stay.
  virtual void Keep() = 0;

  // All frames of this part are there. Throws a Failure with ExitFailed.
  virtual void Finish() = 0;

  // Written by now.
  virtual long long GetBytes() const = 0;
};

// Those of all outputs. Throws a Failure with ExitFailed: a folder that cannot be made, another
// film under way there.
std::vector<std::unique_ptr<FilmSink>> OpenSinks(const Options& options, const FilmPlan& plan);

// The picture of a frame's file number `index`, as the layout of stereo arranges them; `space` is
// for a picture that has to be made.
const Picture& ArrangedPicture(
  const Options& options, const FilmFrame& frame, std::size_t index, Picture& space);
}

#endif
