// SPDX-License-Identifier: BSD-3-Clause
#include "Screenshot.h"

#include "Pictures/PictureFiles.h"
#include "System/OutputFiles.h"
#include "Text/Messages.h"

#include <filesystem>

namespace widefov
{
namespace
{
constexpr int MostScreenshots = 10000; // in one folder

std::string FreeName()
{
  for (int i = 1; i <= MostScreenshots; i++)
  {
    const std::string name = "widefov-viewer-" + std::to_string(i) + ".png";
    std::error_code error;
    if (std::filesystem::symlink_status(name, error).type() ==
      std::filesystem::file_type::not_found)
    {
      return name;
    }
  }
  Fail("there are widefov-viewer-1.png to " + std::to_string(MostScreenshots) +
    " in this folder already; move them away");
}
}

std::string WriteScreenshot(const Picture& picture, const Options& o)
{
  const std::string name = FreeName();
  CheckWritable(name);
  const std::vector<unsigned char> bytes = EncodePicture(picture, name, DescribePanorama(o));
  OutputFiles files;
  files.Write(name, bytes.data(), bytes.size());
  files.Commit();
  return name;
}
}
