// SPDX-License-Identifier: BSD-3-Clause
#include "Loader.h"

#include "CameraSetup.h"
#include "EyeDistance.h"
#include "FirstView.h"
#include "LoadScene.h"

#include <filesystem>
#include <future>
#include <thread>
#include <utility>

namespace widefov
{
namespace
{
// Bytes that even the slowest reader has read before anybody wonders.
constexpr std::uintmax_t FewBytes = 1 << 20;
}

bool TakesLong(const Options& o)
{
  std::uintmax_t bytes = 0;
  for (const std::string& file : o.Files)
  {
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(file, error);
    bytes += error ? 0 : size; // what is not there is said at once
  }
  return bytes > FewBytes;
}

std::string NameOf(const Options& o)
{
  std::string name = o.Scene;
  for (const std::string& file : o.Files)
  {
    name += (name.empty() ? "" : " ") + file;
  }
  return name;
}

Scene LoadFitted(Options& o, bool fits)
{
  Scene scene = LoadScene(o);
  if (fits)
  {
    ChooseView(o, scene);
  }
  MakePose(scene, o); // complains
  if (fits)
  {
    FitEyes(o, scene);
  }
  return scene;
}

struct Loader::Work
{
  Options Fitted;
  std::promise<Scene> Promise;
  std::future<Scene> Result = Promise.get_future();
};

Loader::Loader(const Options& options, bool fits)
  : Shared(std::make_shared<Work>())
{
  this->Shared->Fitted = options;
  std::thread([fits, work = this->Shared] {
    try
    {
      work->Promise.set_value(LoadFitted(work->Fitted, fits));
    }
    catch (...)
    {
      work->Promise.set_exception(std::current_exception());
    }
  }).detach();
}

bool Loader::Wait(std::chrono::milliseconds time)
{
  return this->Shared->Result.wait_for(time) == std::future_status::ready;
}

Scene Loader::Take(Options& options)
{
  Scene scene = this->Shared->Result.get();
  options = this->Shared->Fitted;
  return scene;
}
}
