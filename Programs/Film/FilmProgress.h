// SPDX-License-Identifier: BSD-3-Clause
// How far a film is: frames, time left, size.
#ifndef WideFoVFilmProgress_h
#define WideFoVFilmProgress_h

#include <chrono>
#include <string>

namespace widefov
{
// On a terminal one line that changes twice a second; else a line after two seconds, and again
// every ten.
class FilmProgress
{
public:
  // Of `total` frames `done` are there already.
  FilmProgress(int total, int done, bool quiet);
  ~FilmProgress();
  FilmProgress(const FilmProgress&) = delete;
  FilmProgress& operator=(const FilmProgress&) = delete;

  // Says how far it is, where it is time to. `bytes` were written by now.
  void Update(int done, long long bytes);

private:
  using Clock = std::chrono::steady_clock;

  std::string TextOf(int done, long long bytes) const;

  int Total;
  int First;
  bool Quiet;
  bool Terminal;
  bool Shown = false; // a line stands on the terminal
  Clock::time_point Start = Clock::now();
  Clock::time_point Next;
};
}

#endif
