// SPDX-License-Identifier: BSD-3-Clause
#include "ImageOutput.h"

#include "GPano.h"
#include "ImageSpec.h"
#include "Messages.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <memory>

namespace widefov
{
namespace
{
std::vector<unsigned char> Encode(
  const std::string& writer, const OIIO::ImageSpec& spec, OIIO::TypeDesc type, const void* pixels)
{
  const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(writer);
  if (!output)
  {
    Fail("OpenImageIO has no writer for " + writer + ": " + OIIO::geterror() + "; install one");
  }
  OIIO::Filesystem::IOVecOutput memory;
  output->set_ioproxy(&memory);
  if (!output->open("memory." + writer, spec) || !output->write_image(type, pixels) ||
    !output->close())
  {
    Fail("the picture cannot be encoded as " + writer + ": " + output->geterror() +
      "; choose another format or size");
  }
  return memory.buffer();
}
}

void CheckPictureName(const std::string& path)
{
  if (WriterFor(path).empty())
  {
    FailUsage("--output: '" + path + "' does not end in .png, .jpg, .tif or .exr; choose one");
  }
}

void CheckAovName(const std::string& path)
{
  if (WriterFor(path) != "openexr")
  {
    FailUsage("--aov: '" + path + "' does not end in .exr; rename it");
  }
}

std::vector<unsigned char> EncodePicture(
  const Picture& picture, const std::string& path, const PanoramaInfo& info)
{
  std::vector<unsigned char> bytes =
    Encode(WriterFor(path), PictureSpec(picture.Width, picture.Height, path, info),
      OIIO::TypeDesc::UINT8, picture.Rgb.data());
  InsertInPng(bytes, PngPanorama(picture.Width, picture.Height, path, info));
  return bytes;
}

std::vector<unsigned char> EncodeFloats(const FloatPicture& picture, const PanoramaInfo& info)
{
  return Encode("openexr", FloatSpec(picture.Width, picture.Height, picture.Channels, info),
    OIIO::TypeDesc::FLOAT, picture.Values.data());
}
}
