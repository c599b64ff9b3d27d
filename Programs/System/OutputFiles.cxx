// SPDX-License-Identifier: BSD-3-Clause
#include "OutputFiles.h"

#include "InputFiles.h"
#include "Text/Messages.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <mutex>
#include <set>
#include <sys/stat.h>
#include <unistd.h>

namespace widefov
{
namespace
{
// A link is followed: the file it names is replaced, not the link.
std::string TargetOf(const std::string& path)
{
  if (path == StandardStream)
  {
    return path;
  }
  std::error_code error;
  const std::filesystem::path target = std::filesystem::weakly_canonical(path, error);
  return error ? path : target.string();
}

[[noreturn]] void FailWriting(const std::string& path, int error)
{
  Fail(path + " cannot be written: " + std::strerror(error) +
    "; nothing was changed, so make room or choose another place");
}

[[noreturn]] void FailTemporary(const std::string& why)
{
  Fail(
    "no temporary folder can be made: " + why + "; set TMPDIR to a folder that can be written to");
}

// What goes when the process does, finished or not: files, and folders with all that is in them.
// Never destroyed: threads may end after it would be.
struct UnfinishedPaths
{
  std::mutex Mutex;
  std::set<std::string> Paths;
};

UnfinishedPaths& Unfinished()
{
  static auto* const paths = new UnfinishedPaths;
  return *paths;
}

// A new file, open; below 0 and errno where there can be none.
int CreateUnfinished(const std::string& path)
{
  const std::lock_guard<std::mutex> lock(Unfinished().Mutex);
  const int file = open(path.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (file >= 0)
  {
    Unfinished().Paths.insert(path);
  }
  return file;
}

void NoteUnfinished(const std::string& folder)
{
  const std::lock_guard<std::mutex> lock(Unfinished().Mutex);
  Unfinished().Paths.insert(folder);
}

void ForgetUnfinished(const std::string& path)
{
  const std::lock_guard<std::mutex> lock(Unfinished().Mutex);
  Unfinished().Paths.erase(path);
}

std::string TemporaryPlace()
{
  std::error_code error;
  const std::filesystem::path place = std::filesystem::temp_directory_path(error);
  if (error)
  {
    FailTemporary(error.message());
  }
  return place.string();
}
}

int WriteAllBytes(int file, const char* bytes, std::size_t count)
{
  while (count > 0)
  {
    const ssize_t n = write(file, bytes, count);
    if (n < 0 && errno == EINTR)
    {
      continue;
    }
    if (n <= 0)
    {
      return n < 0 ? errno : ENOSPC;
    }
    bytes += n;
    count -= static_cast<std::size_t>(n);
  }
  return 0;
}

void CheckWritable(const std::string& path)
{
  if (path == StandardStream)
  {
    if (isatty(STDOUT_FILENO) == 1)
    {
      Fail("standard output is a terminal; send the picture on, as in --output - > picture.png");
    }
    return;
  }
  CheckNoInput(path);
  const std::filesystem::path target = TargetOf(path);
  std::error_code error;
  if (std::filesystem::is_directory(target, error))
  {
    Fail(path + " is a folder; name a file in it");
  }
  const std::filesystem::file_status status = std::filesystem::status(target, error);
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
  {
    Fail(path + " is not a regular file; choose another name");
  }
  const std::filesystem::path folder = target.has_parent_path() ? target.parent_path() : ".";
  if (!std::filesystem::is_directory(folder, error))
  {
    Fail(path + ": the folder " + folder.string() + " is not there; make it first");
  }
  if (access(folder.c_str(), W_OK | X_OK) != 0)
  {
    FailWriting(path, errno);
  }
}

void CheckMakeable(const std::string& path)
{
  std::error_code error;
  std::filesystem::path folder = std::filesystem::path(PlainName(path)).parent_path();
  const bool there = std::filesystem::exists(folder, error);
  while (!std::filesystem::exists(folder, error) && folder != folder.root_path())
  {
    folder = folder.parent_path();
  }
  if (there)
  {
    CheckWritable(path);
  }
  else if (!std::filesystem::is_directory(folder, error) ||
    access(folder.c_str(), W_OK | X_OK) != 0)
  {
    Fail("the folder " + std::filesystem::path(path).parent_path().string() +
      " cannot be made in " + folder.string() + "; choose another place");
  }
}

void MakeFolderOf(const std::string& path)
{
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  std::error_code error;
  if (folder.empty() || std::filesystem::is_directory(folder, error))
  {
    return;
  }
  error.clear();
  std::filesystem::create_directories(folder, error);
  if (error)
  {
    Fail("the folder " + folder.string() + " cannot be made: " + error.message() +
      "; choose another place");
  }
  Say("the folder " + folder.string() + " was not there, and is made");
}

void CheckFolder(const std::string& path)
{
  std::error_code error;
  if (!std::filesystem::is_directory(path, error))
  {
    Fail(path + " is no folder; make it first");
  }
  if (access(path.c_str(), W_OK | X_OK) != 0)
  {
    Fail(
      path + ": no file can be written there: " + std::strerror(errno) + "; choose another folder");
  }
}

TemporaryFolder::TemporaryFolder()
{
  this->Path = TemporaryPlace() + "/widefov-XXXXXX";
  if (mkdtemp(&this->Path[0]) == nullptr)
  {
    FailTemporary(std::strerror(errno));
  }
  NoteUnfinished(this->Path);
}

TemporaryFolder::~TemporaryFolder()
{
  std::error_code error;
  std::filesystem::remove_all(this->Path, error);
  ForgetUnfinished(this->Path);
}

void RemoveUnfinished()
{
  Unfinished().Mutex.lock(); // for good
  for (const std::string& path : Unfinished().Paths)
  {
    std::error_code error;
    std::filesystem::remove_all(path, error);
  }
}

std::vector<unsigned char> ReadBytes(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  const std::vector<char> bytes{ std::istreambuf_iterator<char>(file),
    std::istreambuf_iterator<char>() };
  if (!file)
  {
    Fail(path + " cannot be read again; make room, or set TMPDIR to another folder");
  }
  return { bytes.begin(), bytes.end() };
}

OutputFiles::~OutputFiles()
{
  for (const Pending& file : this->Files)
  {
    unlink(file.Beside.c_str());
    ForgetUnfinished(file.Beside);
  }
}

int OutputFiles::Open(const std::string& path)
{
  const std::string target = TargetOf(path);
  CheckNoInput(target);
  const std::string beside = (path == StandardStream ? TemporaryPlace() + "/widefov" : target) +
    ".part-" + std::to_string(getpid()) + "-" + std::to_string(this->Files.size());
  const int file = CreateUnfinished(beside);
  if (file < 0)
  {
    FailWriting(path, errno);
  }
  this->Files.push_back({ beside, target });
  struct stat old = {};
  if (stat(target.c_str(), &old) == 0 && fchmod(file, old.st_mode & 07777) != 0)
  {
    // the new file keeps its own permissions: no reason to lose the picture
  }
  return file;
}

void OutputFiles::Close(int file, const std::string& path, int error)
{
  if (error == 0 && fsync(file) != 0 && errno != EINVAL)
  {
    error = errno;
  }
  if (close(file) != 0 && error == 0)
  {
    error = errno;
  }
  if (error != 0)
  {
    FailWriting(path, error);
  }
}

void OutputFiles::Write(const std::string& path, const void* bytes, std::size_t count)
{
  const int file = this->Open(path);
  this->Close(file, path, WriteAllBytes(file, static_cast<const char*>(bytes), count));
}

void OutputFiles::Commit()
{
  while (!this->Files.empty())
  {
    const Pending& file = this->Files.front();
    if (file.Target == StandardStream)
    {
      const std::vector<unsigned char> bytes = ReadBytes(file.Beside);
      unlink(file.Beside.c_str());
      Print({ bytes.begin(), bytes.end() });
    }
    else if (rename(file.Beside.c_str(), file.Target.c_str()) != 0)
    {
      FailWriting(file.Target, errno);
    }
    ForgetUnfinished(file.Beside);
    this->Files.erase(this->Files.begin());
  }
}
}
