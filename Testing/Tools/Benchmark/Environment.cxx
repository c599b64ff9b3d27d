// SPDX-License-Identifier: BSD-3-Clause
#include "Environment.h"

#include "System/Display.h"

#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkVersion.h>

#include <fstream>
#include <thread>

namespace wfv
{
namespace bench
{
namespace
{
// The text behind the first `key : ` of a file of the kernel; null where there is none.
Json FirstValue(const std::string& path, const std::string& key)
{
  std::ifstream file(path);
  std::string line;
  while (std::getline(file, line))
  {
    const std::size_t colon = line.find(": ");
    if (line.compare(0, key.size(), key) == 0 && colon != std::string::npos)
    {
      return line.substr(colon + 2);
    }
  }
  return nullptr;
}

// "4.5 (Core Profile) Mesa 22.3.6" -> "22.3.6"
Json MesaVersion(const std::string& version)
{
  const std::string name = "Mesa ";
  const std::size_t at = version.find(name);
  return at == std::string::npos ? Json(nullptr) : Json(version.substr(at + name.size()));
}

// Processes that wanted a processor in the last minute: is the machine quiet?
Json LoadAverage()
{
  std::ifstream file("/proc/loadavg");
  double load = 0;
  return file >> load ? Json(load) : Json(nullptr);
}
}

Json DescribeEnvironment()
{
  vtkNew<vtkRenderWindow> window;
  widefov::OpenWindow(window);
  const widefov::GlStrings gl = widefov::QueryStrings(window);
  const bool software = gl.Renderer.find("llvmpipe") != std::string::npos ||
    gl.Renderer.find("softpipe") != std::string::npos;
  return { { "version", WIDEFOV_VERSION },
    { "gl", { { "vendor", gl.Vendor }, { "renderer", gl.Renderer }, { "version", gl.Version } } },
    { "software_rendering", software }, { "vtk", vtkVersion::GetVTKVersion() },
    { "mesa", MesaVersion(gl.Version) }, { "processor", FirstValue("/proc/cpuinfo", "model name") },
    { "cores", std::thread::hardware_concurrency() }, { "load_before", LoadAverage() } };
}
}
}
