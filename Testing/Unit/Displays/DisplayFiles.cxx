// SPDX-License-Identifier: BSD-3-Clause
#include "DisplayFiles.h"

#include <png.h>
#include <zip.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace wfv::test
{
TemporaryFile::TemporaryFile(const std::string& name, const std::string& bytes)
{
  std::string pattern = (std::filesystem::temp_directory_path() / "displays-XXXXXX").string();
  this->Folder = mkdtemp(pattern.data());
  this->Path = this->Folder + "/" + name;
  this->Add(name, bytes);
}

TemporaryFile::~TemporaryFile()
{
  std::error_code error;
  std::filesystem::remove_all(this->Folder, error);
}

void TemporaryFile::Add(const std::string& name, const std::string& bytes) const
{
  std::ofstream file(this->Folder + "/" + name, std::ios::binary);
  file << bytes;
  EXPECT_TRUE(file.good());
}

std::string Text(std::initializer_list<double> numbers)
{
  std::string text;
  char buffer[64];
  for (const double number : numbers)
  {
    std::snprintf(buffer, sizeof buffer, "%.17g", number);
    text += (text.empty() ? "" : " ") + std::string(buffer);
  }
  return text + "\n";
}

std::string Bytes(std::uint32_t number)
{
  std::string bytes;
  for (int i = 0; i < 4; i++)
  {
    bytes += static_cast<char>(number >> (8 * i) & 255);
  }
  return bytes;
}

std::string Bytes(float number)
{
  std::uint32_t bits = 0;
  std::memcpy(&bits, &number, sizeof bits);
  return Bytes(bits);
}

std::string PfmText(int width, int height, const std::vector<vec3>& values, bool bigEndian)
{
  std::string bytes = "PF\n" + std::to_string(width) + " " + std::to_string(height) + "\n" +
    (bigEndian ? "1.0" : "-1.0") + "\n";
  for (const vec3& value : values)
  {
    for (int i = 0; i < 3; i++)
    {
      std::string number = Bytes(static_cast<float>(value[i]));
      if (bigEndian)
      {
        std::reverse(number.begin(), number.end());
      }
      bytes += number;
    }
  }
  return bytes;
}

std::string PngText(int width, int height, const std::vector<double>& values, int bits)
{
  std::string bytes;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  const auto write = [](png_structp to, png_bytep from, png_size_t count) {
    static_cast<std::string*>(png_get_io_ptr(to))->append(reinterpret_cast<char*>(from), count);
  };
  png_set_write_fn(png, &bytes, write, nullptr);
  png_set_IHDR(png, info, static_cast<png_uint_32>(width), static_cast<png_uint_32>(height), bits,
    PNG_COLOR_TYPE_GRAY, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_write_info(png, info);
  const double most = bits == 8 ? 255 : 65535;
  for (int y = 0; y < height; y++)
  {
    std::vector<unsigned char> row;
    for (int x = 0; x < width; x++)
    {
      const auto number =
        static_cast<unsigned>(std::lround(most * values[static_cast<std::size_t>(y) * width + x]));
      if (bits == 16)
      {
        row.push_back(static_cast<unsigned char>(number >> 8));
      }
      row.push_back(static_cast<unsigned char>(number & 255));
    }
    png_write_row(png, row.data());
  }
  png_write_end(png, info);
  png_destroy_write_struct(&png, &info);
  return bytes;
}

std::string ZipText(const std::map<std::string, std::string>& parts)
{
  const TemporaryFile folder("none", "");
  const std::string path = folder.Folder + "/archive.zip";
  zip_t* const archive = zip_open(path.c_str(), ZIP_CREATE, nullptr);
  for (const auto& [name, bytes] : parts)
  {
    zip_source_t* const source = zip_source_buffer(archive, bytes.data(), bytes.size(), 0);
    EXPECT_GE(zip_file_add(archive, name.c_str(), source, ZIP_FL_OVERWRITE), 0);
  }
  EXPECT_EQ(zip_close(archive), 0);
  std::ifstream file(path, std::ios::binary);
  return { std::istreambuf_iterator<char>(file), {} };
}
}
