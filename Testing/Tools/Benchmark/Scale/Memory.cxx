// SPDX-License-Identifier: BSD-3-Clause
#include "Memory.h"

#include "Text/Messages.h"
#include "ScaleScenes.h"
#include "ScaleStage.h"

#include <vtkWideFoVPolyDataMapper.h>

#include <array>
#include <cstdio>
#include <fstream>
#include <malloc.h>
#include <sstream>

namespace wfv
{
namespace scale
{
namespace
{
constexpr int Frames = 4;

// Megabytes behind a key of /proc/self/status.
double ReadStatus(const std::string& key)
{
  std::ifstream file("/proc/self/status");
  std::string line;
  while (std::getline(file, line))
  {
    if (line.compare(0, key.size(), key) == 0)
    {
      return std::stod(line.substr(key.size() + 1)) / 1024;
    }
  }
  return 0;
}

vtkSmartPointer<vtkPolyDataMapper> MakeStock()
{
  return vtkSmartPointer<vtkOpenGLPolyDataMapper>::New();
}

vtkSmartPointer<vtkPolyDataMapper> MakeWide()
{
  return vtkSmartPointer<vtkWideFoVPolyDataMapper>::New();
}

bench::Json RunChild(const std::string& program, const std::string& way, long triangles)
{
  const std::string command = "'" + program + "' --weigh " + way + " --triangles " +
    std::to_string(triangles) + " 2>/dev/null";
  std::FILE* const pipe = popen(command.c_str(), "r");
  std::string text;
  std::array<char, 256> buffer;
  while (pipe != nullptr && std::fgets(buffer.data(), buffer.size(), pipe) != nullptr)
  {
    text += buffer.data();
  }
  if (pipe == nullptr || pclose(pipe) != 0)
  {
    widefov::Fail("the process that weighs '" + way + "' failed; run it alone: " + command);
  }
  return bench::Json::parse(text);
}
}

bench::Json DrawAndWeigh(const std::string& way, long triangles)
{
  const bool wide = way == "wide";
  const vtkSmartPointer<vtkPolyData> sphere = MakeSphere(triangles);
  const Actors actors{ MakeSurface(sphere, wide ? MakeWide : MakeStock) };
  const double data = ReadStatus("VmRSS:");
  const vtkSmartPointer<vtkRenderWindow> window = MakeWindow(1024, 512, false);
  std::vector<ScaleRun> runs{ wide ? MakeWideRun(way, actors, "equirectangular", 360, 180)
                                   : MakeStockRun(way, actors, 90) };
  DrawInTurn(window, runs, Frames, [](const ScaleRun&, int) {});
  bench::Json json{ { "data_mb", data }, { "peak_mb", ReadStatus("VmHWM:") },
    { "still_mb", ReadStatus("VmRSS:") } };
  malloc_trim(0);
  json["trimmed_mb"] = ReadStatus("VmRSS:");
  return json;
}

bench::Json CompareMemory(const std::string& program, long triangles)
{
  const bench::Json stock = RunChild(program, "stock", triangles);
  const bench::Json wide = RunChild(program, "wide", triangles);
  const auto ratio = [&](const char* key) {
    return wide[key].get<double>() / stock[key].get<double>();
  };
  return { { "triangles", triangles }, { "stock", stock }, { "wide", wide },
    { "peak_ratio", ratio("peak_mb") }, { "still_ratio", ratio("still_mb") } };
}
}
}
