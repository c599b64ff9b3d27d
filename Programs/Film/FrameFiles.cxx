// SPDX-License-Identifier: BSD-3-Clause
#include "FrameFiles.h"

#include "Options/FilmOptions.h"
#include "Pictures/PictureFiles.h"
#include "System/OutputFiles.h"
#include "Text/Messages.h"

#include <filesystem>

namespace widefov
{
namespace
{
void MakeFolderOf(const std::string& path)
{
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  std::error_code error;
  if (!folder.empty())
  {
    std::filesystem::create_directories(folder, error);
  }
  if (error)
  {
    Fail("the folder " + folder.string() + " cannot be made: " + error.message() +
      "; choose another place");
  }
}
}

FrameFiles::FrameFiles(const Options& o, const std::string& output)
  : What(o)
{
  for (const std::string& name : FilesOfFilm(o, output))
  {
    MakeFolderOf(name);
    this->Names.push_back(*NumberPattern::Parse(name));
    CheckWritable(this->Names.back().Name(1));
  }
}

bool FrameFiles::Has(int frame) const
{
  bool all = this->What.Film.Resume;
  for (const NumberPattern& name : this->Names)
  {
    std::error_code error;
    all = all && std::filesystem::is_regular_file(name.Name(frame + 1LL), error);
  }
  return all;
}

void FrameFiles::Add(const FilmFrame& frame)
{
  OutputFiles files;
  const auto write = [&](const std::string& name, const std::vector<unsigned char>& bytes) {
    files.Write(name, bytes.data(), bytes.size());
    this->Bytes += static_cast<long long>(bytes.size());
  };
  if (this->Names.size() == 1)
  {
    const std::string name = this->Names[0].Name(frame.Number + 1LL);
    for (const auto& encoded : EncodeFiles(this->What, name, frame.Drawn))
    {
      write(encoded.first, encoded.second);
    }
  }
  for (std::size_t i = 0; i < this->Names.size() && this->Names.size() > 1; i++)
  {
    const std::string name = this->Names[i].Name(frame.Number + 1LL);
    write(name, EncodePicture(frame.Drawn[i], name, DescribePanorama(this->What)));
  }
  files.Commit();
}
}
