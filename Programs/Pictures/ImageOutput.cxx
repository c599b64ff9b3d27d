// SPDX-License-Identifier: BSD-3-Clause
#include "ImageOutput.h"

#include "GPano.h"
#include "ImageSpec.h"
#include "JpegXmp.h"
#include "Options/OutputNames.h"
#include "System/OutputFiles.h"
#include "Text/Messages.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <memory>
#include <optional>

namespace widefov
{
namespace
{
struct Part
{
  OIIO::ImageSpec Spec;
  const void* Pixels;
};

bool WriteParts(OIIO::ImageOutput& output, const std::string& name, const std::vector<Part>& parts,
  OIIO::TypeDesc type)
{
  std::vector<OIIO::ImageSpec> specs;
  for (const Part& part : parts)
  {
    specs.push_back(part.Spec);
  }
  const bool several = parts.size() > 1;
  bool done = several ? output.open(name, static_cast<int>(specs.size()), specs.data())
                      : output.open(name, specs[0]);
  for (std::size_t i = 0; done && i < parts.size(); i++)
  {
    done = (i == 0 || output.open(name, specs[i], OIIO::ImageOutput::AppendSubimage)) &&
      output.write_image(type, parts[i].Pixels);
  }
  return done && output.close();
}

std::vector<unsigned char> Encode(
  const std::string& writer, const std::vector<Part>& parts, OIIO::TypeDesc type)
{
  std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(writer);
  if (!output)
  {
    Fail("OpenImageIO has no writer for " + writer + ": " + OIIO::geterror() + "; install one");
  }
  // a file of several parts is not written to memory
  const std::optional<TemporaryFolder> folder(
    parts.size() > 1 ? std::make_optional<TemporaryFolder>() : std::nullopt);
  OIIO::Filesystem::IOVecOutput memory;
  if (!folder)
  {
    output->set_ioproxy(&memory);
  }
  const std::string name = (folder ? folder->GetPath() + "/parts." : "memory.") + writer;
  if (!WriteParts(*output, name, parts, type))
  {
    Fail("the picture cannot be encoded as " + writer + ": " + output->geterror() +
      "; choose another format or size");
  }
  output.reset(); // what it holds back is on the disk now
  return folder ? ReadBytes(name) : memory.buffer();
}
}

std::vector<unsigned char> EncodePicture(
  const Picture& picture, const std::string& path, const PanoramaInfo& info)
{
  const OIIO::ImageSpec spec = PictureSpec(picture.Width, picture.Height, path, info);
  std::vector<unsigned char> bytes =
    Encode(WriterFor(path), { { spec, picture.Rgb.data() } }, OIIO::TypeDesc::UINT8);
  InsertInPng(bytes, PngPanorama(picture.Width, picture.Height, path, info));
  if (info.Equirectangular && WriterFor(path) == "jpeg" && !info.StereoMode.empty())
  {
    InsertJpegXmp(bytes, SphericalXmp(picture.Width, picture.Height, info), "");
  }
  return bytes;
}

std::vector<unsigned char> EncodeMultiView(
  const std::vector<Picture>& eyes, const PanoramaInfo& info)
{
  const char* const names[] = { "left", "right" };
  std::vector<Part> parts;
  for (std::size_t i = 0; i < eyes.size(); i++)
  {
    OIIO::ImageSpec spec = PictureSpec(eyes[i].Width, eyes[i].Height, "eye.exr", info);
    spec.attribute("oiio:subimagename", names[i]);
    spec.attribute("view", names[i]);
    parts.push_back({ spec, eyes[i].Rgb.data() });
  }
  return Encode("openexr", parts, OIIO::TypeDesc::UINT8);
}

std::vector<unsigned char> EncodeVr180Photo(
  const std::vector<Picture>& eyes, const PanoramaInfo& info)
{
  PanoramaInfo bare;
  bare.Description = info.Description;
  const std::vector<unsigned char> right = EncodePicture(eyes[1], "right.jpg", bare);
  std::vector<unsigned char> left = EncodePicture(eyes[0], "left.jpg", bare);
  const std::string extended = Vr180Extension(right);
  const std::string xmp = Vr180Xmp(eyes[0].Width, eyes[0].Height, info, extended);
  InsertJpegXmp(left, xmp, extended);
  return left;
}

std::vector<unsigned char> EncodeFloats(const FloatPicture& picture, const PanoramaInfo& info)
{
  const OIIO::ImageSpec spec = FloatSpec(picture.Width, picture.Height, picture.Channels, info);
  return Encode("openexr", { { spec, picture.Values.data() } }, OIIO::TypeDesc::FLOAT);
}
}
