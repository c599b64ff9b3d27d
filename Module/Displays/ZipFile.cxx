// SPDX-License-Identifier: BSD-3-Clause
#include "ZipFile.h"

#include "FileText.h"

#include <zip.h>

#include <filesystem>

namespace wfv::displays
{
bool PointsOutside(const std::string& name)
{
  std::string slashes = name;
  for (char& c : slashes)
  {
    c = c == '\\' ? '/' : c;
  }
  const bool drive = name.size() > 1 && name[1] == ':';
  if (drive || name.empty() || slashes[0] == '/')
  {
    return true;
  }
  for (const auto& part : std::filesystem::path(slashes))
  {
    if (part == "..")
    {
      return true;
    }
  }
  return false;
}

ZipFile::ZipFile(const std::string& path)
  : Path(path)
{
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error))
  {
    throw FileError(path + " is not there, or no file; check the name");
  }
  this->Archive = zip_open(path.c_str(), ZIP_RDONLY, nullptr);
  if (!this->Archive)
  {
    throw FileError(path + " is cut, or no zip archive; get the whole file");
  }
  const zip_int64_t count = zip_get_num_entries(this->Archive, 0);
  for (zip_int64_t i = 0; i < count; i++)
  {
    const char* const name = zip_get_name(this->Archive, static_cast<zip_uint64_t>(i), 0);
    this->Parts.emplace_back(name ? name : "");
    if (PointsOutside(this->Parts.back()))
    {
      const std::string outside = this->Parts.back();
      zip_discard(this->Archive);
      throw FileError(path + ": its part '" + outside + "' points outside of the archive");
    }
  }
}

ZipFile::~ZipFile()
{
  zip_discard(this->Archive);
}

std::string ZipFile::Read(const std::string& name) const
{
  zip_stat_t about;
  zip_stat_init(&about);
  if (zip_stat(this->Archive, name.c_str(), ZIP_FL_NOCASE, &about) != 0)
  {
    throw FileError(this->Path + " has no part '" + name + "'; get the whole file");
  }
  if ((about.valid & ZIP_STAT_SIZE) == 0 || about.size > LargestFile)
  {
    throw FileError(this->Path + ": its part '" + name + "' is larger than 1 GiB");
  }
  const std::unique_ptr<zip_file_t, int (*)(zip_file_t*)> file(
    zip_fopen_index(this->Archive, about.index, 0), zip_fclose);
  std::string bytes(about.size, '\0');
  const zip_int64_t read = file ? zip_fread(file.get(), bytes.data(), about.size) : -1;
  char more = 0;
  // (the end is read as well: there the sum of the bytes is checked)
  if (read != static_cast<zip_int64_t>(about.size) || zip_fread(file.get(), &more, 1) != 0)
  {
    throw FileError(this->Path + ": its part '" + name + "' is damaged; get the whole file");
  }
  return bytes;
}
}
