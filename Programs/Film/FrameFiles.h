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
  // Makes the folders.
  FrameFiles(const Options& options, const std::string& output);

  bool Has(int frame) const override;
  void Add(const FilmFrame& frame) override;
  void Keep() override {}
  void Finish() override {}
  long long GetBytes() const override { return this->Bytes; }

private:
  const Options& What;
  std::vector<NumberPattern> Names; // one a file of a frame
  std::atomic<long long> Bytes{ 0 };
};
}

#endif
