// SPDX-License-Identifier: BSD-3-Clause
#include "FileText.h"
#include "Readers.h"

#include <png.h>

#include <csetjmp>
#include <cstring>

namespace wfv::displays
{
namespace
{
struct Source
{
  const std::string* Bytes;
  std::size_t At;
};

void Take(png_structp png, png_bytep to, png_size_t count)
{
  Source& source = *static_cast<Source*>(png_get_io_ptr(png));
  if (source.Bytes->size() - source.At < count)
  {
    png_error(png, "cut");
  }
  std::memcpy(to, source.Bytes->data() + source.At, count);
  source.At += count;
}

// Rows of 16-bit numbers, the highest byte first, of 1 (grey) or 3 channels.
struct Decoded
{
  std::size_t Width = 0;
  std::size_t Height = 0;
  std::size_t Channels = 0;
  std::vector<unsigned char> Bytes;
  std::vector<png_bytep> Rows;
};

// Everything that has a destructor is outside of this function, which libpng may leave by a jump.
bool Decode(png_structp png, png_infop info, Decoded& image)
{
  if (setjmp(png_jmpbuf(png)) != 0)
  {
    return false;
  }
  png_read_info(png, info);
  image.Width = png_get_image_width(png, info);
  image.Height = png_get_image_height(png, info);
  if (image.Width * image.Height > LargestCount)
  {
    return false;
  }
  png_set_expand_16(png);
  png_set_strip_alpha(png);
  png_set_interlace_handling(png);
  png_read_update_info(png, info);
  image.Channels = png_get_channels(png, info);
  const std::size_t row = png_get_rowbytes(png, info);
  image.Bytes.resize(row * image.Height);
  image.Rows.resize(image.Height);
  for (std::size_t y = 0; y < image.Height; y++)
  {
    image.Rows[y] = &image.Bytes[row * y];
  }
  png_read_image(png, image.Rows.data());
  return true;
}

void Quiet(png_structp, png_const_charp) {}

[[noreturn]] void Jump(png_structp png, png_const_charp)
{
  png_longjmp(png, 1);
}
}

Mask ReadPng(const std::string& path, const std::string& bytes)
{
  Source source{ &bytes, 0 };
  Decoded image;
  png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, Jump, Quiet);
  png_infop info = png ? png_create_info_struct(png) : nullptr;
  bool good = info != nullptr;
  if (good)
  {
    png_set_read_fn(png, &source, Take);
    good = Decode(png, info, image);
  }
  png_destroy_read_struct(&png, &info, nullptr);
  if (!good)
  {
    throw FileError(path + " is cut, or no PNG image; check the file");
  }
  Mask mask{ static_cast<int>(image.Width), static_cast<int>(image.Height), {} };
  mask.Values.reserve(image.Width * image.Height);
  for (std::size_t y = image.Height; y-- > 0;)
  {
    const png_bytep row = image.Rows[y];
    for (std::size_t x = 0; x < image.Width; x++)
    {
      double sum = 0;
      for (std::size_t c = 0; c < image.Channels; c++)
      {
        const png_bytep at = row + 2 * (x * image.Channels + c);
        sum += 256 * at[0] + at[1];
      }
      mask.Values.push_back(static_cast<float>(sum / (65535. * double(image.Channels))));
    }
  }
  return mask;
}
}
