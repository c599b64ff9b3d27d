// SPDX-License-Identifier: BSD-3-Clause
// Files that hold both eyes, read again.
#include "Pictures/ImageOutput.h"
#include "Pictures/JpegXmp.h"
#include "Text/Messages.h"
#include "System/OutputFiles.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <string>

using namespace widefov;

namespace
{
// Every pixel different, and the eyes.
Picture MakePicture(int seed)
{
  Picture p;
  p.Width = 13;
  p.Height = 7;
  for (int i = 0; i < 3 * p.Width * p.Height; i++)
  {
    p.Rgb.push_back(static_cast<unsigned char>((i * 37 + seed) % 256));
  }
  return p;
}

std::vector<unsigned char> ReadPart(OIIO::ImageInput& input, int part)
{
  const OIIO::ImageSpec spec = input.spec(part);
  std::vector<float> values(static_cast<std::size_t>(spec.image_pixels()) * spec.nchannels);
  EXPECT_TRUE(input.read_image(part, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, values.data()));
  std::vector<unsigned char> bytes;
  for (const float value : values)
  {
    bytes.push_back(static_cast<unsigned char>(std::lround(255 * value)));
  }
  return bytes;
}
}

TEST(MultiView, HoldsBothEyes)
{
  const std::vector<Picture> eyes{ MakePicture(1), MakePicture(90) };
  PanoramaInfo whole;
  whole.Equirectangular = true;
  const std::vector<unsigned char> bytes = EncodeMultiView(eyes, whole);
  const TemporaryFolder folder;
  const std::string path = folder.GetPath() + "/eyes.exr";
  std::ofstream(path, std::ios::binary)
    .write(reinterpret_cast<const char*>(bytes.data()), static_cast<long>(bytes.size()));
  const auto input = OIIO::ImageInput::open(path);
  ASSERT_TRUE(input) << OIIO::geterror();
  const char* const names[] = { "left", "right" };
  for (int part = 0; part < 2; part++)
  {
    ASSERT_TRUE(input->seek_subimage(part, 0)) << part;
    EXPECT_EQ(input->spec().get_string_attribute("oiio:subimagename"), names[part]);
    EXPECT_EQ(input->spec().get_string_attribute("view"), names[part]);
    EXPECT_EQ(input->spec().get_string_attribute("textureformat"), "LatLong Environment");
    EXPECT_EQ(input->spec().channelnames, (std::vector<std::string>{ "R", "G", "B" }));
    EXPECT_EQ(ReadPart(*input, part), eyes[static_cast<std::size_t>(part)].Rgb);
  }
  EXPECT_FALSE(input->seek_subimage(2, 0));
}

TEST(Vr180Photo, IsAPictureOfTheLeftEye)
{
  const std::vector<Picture> eyes{ MakePicture(1), MakePicture(90) };
  PanoramaInfo half;
  half.Equirectangular = true;
  half.HorizontalFov = 180;
  const std::vector<unsigned char> photo = EncodeVr180Photo(eyes, half);
  const std::vector<unsigned char> left = EncodePicture(eyes[0], "left.jpg", PanoramaInfo());
  OIIO::Filesystem::IOMemReader memory(const_cast<unsigned char*>(photo.data()), photo.size());
  OIIO::Filesystem::IOMemReader plain(const_cast<unsigned char*>(left.data()), left.size());
  const auto input = OIIO::ImageInput::open("memory.jpg", nullptr, &memory);
  const auto other = OIIO::ImageInput::open("memory.jpg", nullptr, &plain);
  ASSERT_TRUE(input && other) << OIIO::geterror();
  EXPECT_EQ(ReadPart(*input, 0), ReadPart(*other, 0));
}

TEST(JpegXmp, RefusesWhatIsNoJpeg)
{
  std::vector<unsigned char> nothing{ 1, 2, 3, 4, 5 };
  EXPECT_THROW(InsertJpegXmp(nothing, "x", ""), Failure);
  std::vector<unsigned char> jpeg = EncodePicture(MakePicture(1), "p.jpg", PanoramaInfo());
  EXPECT_THROW(InsertJpegXmp(jpeg, std::string(70000, 'x'), ""), Failure);
}

TEST(JpegXmp, AnExtensionLongerThanASegmentComesBackWhole)
{
  std::vector<unsigned char> jpeg = EncodePicture(MakePicture(1), "p.jpg", PanoramaInfo());
  std::string extension;
  for (int i = 0; i < 150000; i++)
  {
    extension += static_cast<char>('a' + i * 7 % 26);
  }
  InsertJpegXmp(jpeg, "packet", extension);
  const std::string all(jpeg.begin(), jpeg.end());
  const std::string name = std::string("http://ns.adobe.com/xmp/extension/") + '\0';
  std::string found;
  for (std::size_t at = all.find(name); at != std::string::npos; at = all.find(name, at + 1))
  {
    const auto length = static_cast<std::size_t>(
      (static_cast<unsigned char>(all[at - 2]) << 8) + static_cast<unsigned char>(all[at - 1]));
    const std::size_t head = name.size() + 32 + 4 + 4;
    found += all.substr(at + head, length - 2 - head);
  }
  EXPECT_EQ(found, extension);
}
