// SPDX-License-Identifier: BSD-3-Clause
#include "FrameOwner.h"

#include "Options/FilmIdentity.h"
#include "Options/OutputNames.h"
#include "Text/Messages.h"

#include <OpenImageIO/imageio.h>

#include <filesystem>
#include <fstream>
#include <memory>

namespace widefov
{
namespace
{
bool EndsWith(const std::string& path, const std::string& mark)
{
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  const auto size = static_cast<std::streamoff>(mark.size());
  std::string end(mark.size(), '\0');
  return file && file.tellg() >= size && file.seekg(-size, std::ios::end) &&
    file.read(&end[0], size) && end == mark;
}

bool ReadsWhole(const std::string& path)
{
  const std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::open(path);
  std::vector<float> pixels;
  bool whole = input != nullptr;
  for (int part = 0; whole && (part == 0 || input->seek_subimage(part, 0)); part++)
  {
    pixels.resize(input->spec().image_pixels() * input->spec().nchannels);
    whole = input->read_image(part, 0, 0, -1, OIIO::TypeDesc::FLOAT, pixels.data());
  }
  return whole;
}
}

FrameState StateOfFrame(const std::string& path)
{
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error))
  {
    return FrameState::Missing;
  }
  const std::string writer = WriterFor(path);
  const bool whole = writer == "png" ? EndsWith(path, std::string("IEND\xae\x42\x60\x82"))
    : writer == "jpeg"               ? EndsWith(path, "\xff\xd9")
                                     : ReadsWhole(path);
  return whole ? FrameState::Whole : FrameState::Cut;
}

void CheckOwner(const std::string& path, const std::string& command)
{
  const std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::open(path);
  const std::string other =
    input ? std::string(input->spec().get_string_attribute("ImageDescription")) : "";
  const std::string difference = FilmDifference(command, other);
  if (!difference.empty())
  {
    Fail(path + " is not of this film: " + difference +
      "; give the same options, remove the frames, or draw all of them without --resume");
  }
}
}
