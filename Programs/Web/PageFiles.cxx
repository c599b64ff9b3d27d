// SPDX-License-Identifier: BSD-3-Clause
#include "PageFiles.h"

#include "System/InputFiles.h"
#include "Text/Messages.h"

#include <OpenImageIO/strutil.h>

#include <cstdlib>
#include <filesystem>
#include <regex>

namespace widefov
{
namespace
{
namespace fs = std::filesystem;

const char* const ViewerFiles[] = { "index.html", "viewer.js", "viewer.css", "licences.txt" };

// Names of files of a page. Films have a folder while they are drawn.
const std::regex PageFile(
  "index\\.html|viewer\\.(js|css)|licences\\.txt|page\\.js|bar\\.png(\\.js)?|"
  "panorama(-right)?\\.jpg(\\.js)?|film\\.mp4(\\.js)?|"
  "tiles/\\d+-\\d+-\\d+\\.jpg(\\.js)?");
const std::regex FilmFolder("film\\.mp4\\.parts");

// Largest film with a twin, bytes: base64 makes it a text of 400 million letters, and Chromium
// takes 512.
constexpr std::uintmax_t LargestTwin = 300'000'000;

// Beside a program lies its data: bin/widefov-render, share/widefov/web.
fs::path BesideProgram()
{
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  return program.parent_path().parent_path() / "share" / "widefov" / "web";
}

const char* TypeOf(const std::string& name)
{
  const std::string ending = fs::path(name).extension().string();
  return ending == ".mp4" ? "video/mp4" : ending == ".png" ? "image/png" : "image/jpeg";
}

// All files below the folder, by their names in it.
std::vector<std::string> NamesIn(const std::string& folder)
{
  std::vector<std::string> names;
  std::error_code error;
  fs::recursive_directory_iterator it(folder, error);
  for (; !error && it != fs::recursive_directory_iterator(); it.increment(error))
  {
    const std::string name = it->path().lexically_relative(folder).string();
    if (it->is_directory() && std::regex_match(name, FilmFolder))
    {
      it.disable_recursion_pending();
    }
    else if (!it->is_directory() || name != "tiles")
    {
      names.push_back(name);
    }
  }
  if (error)
  {
    Fail(folder + " cannot be read: " + error.message() + "; choose another folder");
  }
  return names;
}
}

std::string ViewerFolder()
{
  const char* const data = std::getenv("WIDEFOV_DATA_DIR");
  for (const fs::path& folder : { fs::path(data != nullptr ? data : "") / "web", BesideProgram() })
  {
    if (fs::exists(folder / "viewer.js"))
    {
      return folder.string();
    }
  }
  Fail("--web: the viewer of web pages is not in " + BesideProgram().string() +
    "; in a checkout make it by Utilities/fetch-viewer.sh");
}

void CheckPageFolder(const std::string& folder)
{
  std::error_code error;
  if (fs::exists(folder, error) && !fs::is_directory(folder, error))
  {
    Fail(folder + " is no folder; give --web another name");
  }
  CheckMakeable(folder + "/index.html");
  if (!fs::exists(folder, error))
  {
    return;
  }
  for (const std::string& name : NamesIn(folder))
  {
    if (!std::regex_match(name, PageFile))
    {
      Fail(folder + " has other things than a web page in it, such as " + name +
        "; give --web a new or empty folder");
    }
    CheckNoInput((fs::path(folder) / name).string()); // files of an older page are removed
  }
}

void PageFiles::Add(const std::string& name, const void* bytes, std::size_t count)
{
  const fs::path path = fs::path(this->Folder) / name;
  std::error_code error;
  fs::create_directories(path.parent_path(), error); // writing says what is wrong
  this->Files.Write(path.string(), bytes, count);
  this->Names.insert(name);
}

void PageFiles::WriteTwin(const std::string& name, const std::vector<unsigned char>& bytes)
{
  const std::string text = "widefov.file(\"" + name + "\", \"data:" + TypeOf(name) + ";base64," +
    OIIO::Strutil::base64_encode(
      OIIO::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size())) +
    "\");\n";
  this->Add(name + ".js", text.data(), text.size());
}

void PageFiles::AddWithTwin(const std::string& name, const std::vector<unsigned char>& bytes)
{
  this->Add(name, bytes.data(), bytes.size());
  this->WriteTwin(name, bytes);
}

bool PageFiles::AddTwin(const std::string& name)
{
  this->Names.insert(name);
  const std::string path = this->Folder + "/" + name;
  std::error_code error;
  if (fs::file_size(path, error) > LargestTwin)
  {
    return false;
  }
  this->WriteTwin(name, ReadBytes(path));
  return true;
}

void PageFiles::Commit()
{
  const std::string viewer = ViewerFolder();
  for (const char* const name : ViewerFiles)
  {
    const std::vector<unsigned char> bytes = ReadBytes(viewer + "/" + name);
    this->Add(name, bytes.data(), bytes.size());
  }
  this->Files.Commit();
  std::error_code error;
  for (const std::string& name : NamesIn(this->Folder))
  {
    if (this->Names.count(name) == 0 && std::regex_match(name, PageFile))
    {
      fs::remove(fs::path(this->Folder) / name, error);
    }
  }
  fs::remove(fs::path(this->Folder) / "tiles", error); // if it is empty
}
}
