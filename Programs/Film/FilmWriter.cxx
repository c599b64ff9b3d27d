// SPDX-License-Identifier: BSD-3-Clause
#include "FilmWriter.h"

namespace widefov
{
namespace
{
constexpr std::size_t MostWaiting = 2; // a frame of a large dome is 200 MB
}

FilmWriter::FilmWriter(std::vector<std::unique_ptr<FilmSink>>& sinks)
  : Sinks(sinks)
  , Worker([this] { this->Work(); })
{
}

FilmWriter::~FilmWriter()
{
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Ended = true;
  }
  this->Changed.notify_all();
  this->Worker.join();
}

void FilmWriter::Push(FilmFrame frame)
{
  std::unique_lock<std::mutex> lock(this->Mutex);
  this->Changed.wait(lock, [this] { return this->Error || this->Waiting.size() < MostWaiting; });
  if (this->Error)
  {
    std::rethrow_exception(this->Error);
  }
  this->Waiting.push_back(std::move(frame));
  this->Changed.notify_all();
}

void FilmWriter::Drain()
{
  std::unique_lock<std::mutex> lock(this->Mutex);
  this->Changed.wait(
    lock, [this] { return this->Error || (this->Waiting.empty() && !this->Busy); });
  if (this->Error)
  {
    std::rethrow_exception(this->Error);
  }
}

void FilmWriter::Write(const FilmFrame& frame)
{
  for (const std::unique_ptr<FilmSink>& sink : this->Sinks)
  {
    if (!sink->Has(frame.Number))
    {
      sink->Add(frame);
    }
  }
  ++this->Written;
}

void FilmWriter::Work()
{
  std::unique_lock<std::mutex> lock(this->Mutex);
  while (true)
  {
    this->Changed.wait(lock, [this] { return this->Ended || !this->Waiting.empty(); });
    if (this->Waiting.empty() || this->Error)
    {
      return;
    }
    const FilmFrame frame = std::move(this->Waiting.front());
    this->Waiting.pop_front();
    this->Busy = true;
    lock.unlock();
    std::exception_ptr error;
    try
    {
      this->Write(frame);
    }
    catch (...)
    {
      error = std::current_exception();
    }
    lock.lock();
    this->Error = error;
    this->Busy = false;
    this->Changed.notify_all();
    if (error)
    {
      return;
    }
  }
}
}
