// SPDX-License-Identifier: BSD-3-Clause
// A line for anything that takes more than two seconds.
#ifndef WideFoVProgress_h
#define WideFoVProgress_h

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace widefov
{
// While one of these lives, what it is about is said after two seconds, and again
// every ten.
class Progress
{
public:
  explicit Progress(const std::string& what);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  // How far it is, from 0 to 1; below 0 means unknown (the default).
  void Update(double fraction) { this->Fraction = fraction; }

private:
  void Watch();

  std::string What;
  std::atomic<double> Fraction{ -1 };
  std::mutex Mutex;
  std::condition_variable Ended;
  bool Done = false;
  std::thread Watcher;
};
}

#endif
