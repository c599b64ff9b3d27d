// SPDX-License-Identifier: BSD-3-Clause
// Encodes and writes frames while others are drawn.
#ifndef WideFoVFilmWriter_h
#define WideFoVFilmWriter_h

#include "FilmSink.h"

#include <atomic>
#include <condition_variable>
#include <deque>
#include <exception>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

namespace widefov
{
class FilmWriter
{
public:
  explicit FilmWriter(std::vector<std::unique_ptr<FilmSink>>& sinks);

  // Frames that wait are written first.
  ~FilmWriter();
  FilmWriter(const FilmWriter&) = delete;
  FilmWriter& operator=(const FilmWriter&) = delete;

  // Waits where two frames do. Throws what a sink threw.
  void Push(FilmFrame frame);

  // Waits until all are written. Throws what a sink threw.
  void Drain();

  // Frames that every sink has got.
  int GetWritten() const { return this->Written; }

private:
  void Work();
  void Write(const FilmFrame& frame);

  std::vector<std::unique_ptr<FilmSink>>& Sinks;
  std::mutex Mutex;
  std::condition_variable Changed;
  std::deque<FilmFrame> Waiting;
  bool Busy = false;
  bool Ended = false;
  std::exception_ptr Error;
  std::atomic<int> Written{ 0 };
  std::thread Worker;
};
}

#endif
