// SPDX-License-Identifier: BSD-3-Clause
// A film as one file, which ffmpeg encodes.
#ifndef WideFoVFilmFile_h
#define WideFoVFilmFile_h

#include "FilmParts.h"
#include "FilmSink.h"
#include "Options/Codecs.h"
#include "System/ChildProcess.h"

#include <array>
#include <atomic>
#include <chrono>
#include <optional>

namespace widefov
{
class FilmFile : public FilmSink
{
public:
  // `path` is file number `index` of those that hold a frame.
  FilmFile(
    const Options& options, const FilmPlan& plan, const std::string& path, std::size_t index);

  bool Has(int frame) const override { return !this->Parts || this->Parts->Has(frame); }
  void Add(const FilmFrame& frame) override;
  void Keep() override;
  void Finish() override;
  long long GetBytes() const override { return this->Bytes; }

private:
  void StartRun(int frame);
  void EndRun();
  [[noreturn]] void FailEncoding();
  void Join(const std::string& list);

  const Options& What;
  FilmPlan Plan;
  std::string Path;
  std::size_t Index;
  const Container& Kind;
  const Codec& Coding;
  std::optional<FilmParts> Parts; // none: the film is whole already
  std::unique_ptr<ChildProcess> Encoder;
  std::string Scratch; // the file it writes
  int FirstOfRun = 0;
  int Last = 0;
  std::chrono::steady_clock::time_point RunStart;
  std::atomic<long long> Bytes{ 0 };
};
}

#endif
