// SPDX-License-Identifier: BSD-3-Clause
// A film as numbered pictures.
#ifndef WideFoVFrameFiles_h
#define WideFoVFrameFiles_h

#include "FilmSink.h"
#include "Scenes/NumberPattern.h"

#include <atomic>

namespace widefov
{
// The first frame has the number 1, as ffmpeg and modellers count. Each appears whole or not at
// all.
class FrameFiles : public FilmSink
{
public:
  // Makes the folders. Throws a Failure with ExitFailed: a frame would overwrite an input, or
  // frames are to be kept that another film has left there.
  FrameFiles(const Options& options, const FilmPlan& plan, const std::string& output);

  bool Has(int frame) const override { return this->Present[static_cast<std::size_t>(frame)]; }
  void Add(const FilmFrame& frame) override;
  void Keep() override {}
  void Finish() override {}
  long long GetBytes() const override { return this->Bytes; }

private:
  void CheckInputs() const;
  void FindPresent();
  void SayWhatIsLeft() const;

  const Options& What;
  int Frames;
  std::vector<NumberPattern> Names; // one a file of a frame
  std::vector<bool> Present;        // with --resume: frames that are whole
  std::atomic<long long> Bytes{ 0 };
};
}

#endif
