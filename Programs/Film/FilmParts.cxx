// SPDX-License-Identifier: BSD-3-Clause
#include "FilmParts.h"

#include "Options/FilmIdentity.h"
#include "System/OutputFiles.h"
#include "Text/Messages.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <regex>
#include <sys/file.h>
#include <unistd.h>

namespace widefov
{
namespace
{
constexpr char LockEnding[] = ".lock"; // of a file that who draws a part has locked

const char* const CommandFile = "film.txt";

[[noreturn]] void FailFolder(const std::string& folder, const std::string& why)
{
  Fail(folder + ": frames cannot be kept there: " + why + "; make room or choose another place");
}

// What was written is on the disk before it gets its name.
void Sync(const std::string& path)
{
  const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file >= 0)
  {
    fsync(file);
    close(file);
  }
}
}

LockedFile::LockedFile(const std::string& path, bool wait)
  : Path(path)
  , File(open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666))
{
  if (this->File < 0)
  {
    FailFolder(path, std::strerror(errno));
  }
  int result = 0;
  do
  {
    result = flock(this->File, wait ? LOCK_EX : LOCK_EX | LOCK_NB);
  } while (result != 0 && errno == EINTR);
  if (result != 0)
  {
    close(this->File);
    this->File = -1;
  }
}

LockedFile::~LockedFile()
{
  if (this->File >= 0)
  {
    unlink(this->Path.c_str());
    close(this->File);
  }
}

namespace
{
// Some process draws a part of the film just now.
bool IsAtWork(const std::string& folder)
{
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error))
  {
    const std::string path = entry.path().string();
    if (entry.path().extension() == LockEnding && !LockedFile(path, false).IsMine())
    {
      return true;
    }
  }
  return false;
}
}

FilmParts::FilmParts(const std::string& film, const std::string& segment,
  const FilmOptions& options, const FilmPlan& plan)
  : Film(film)
  , Folder(FolderOf(film))
  , Segment(segment)
  , Own("part-" + std::to_string(options.Part) + "-of-" + std::to_string(options.Parts))
  , Plan(plan)
  , Present(static_cast<std::size_t>(plan.Frames))
{
  std::error_code error;
  if (std::filesystem::exists(this->Folder, error) && !options.Resume && options.Parts == 1)
  {
    Fail(IsAtWork(this->Folder)
        ? film + ": another process draws this film; wait for it, or choose another name"
        : this->Folder +
          " keeps frames of a film that is not whole; give --resume to go on with it, "
          "or remove the folder");
  }
  std::filesystem::create_directory(this->Folder, error);
  if (error)
  {
    FailFolder(this->Folder, error.message());
  }
  this->Claim(options);
  for (const Run& run : this->FindRuns())
  {
    std::fill(this->Present.begin() + run.First, this->Present.begin() + run.Last + 1, true);
  }
}

void FilmParts::Claim(const FilmOptions& options)
{
  this->Lock.emplace(this->Folder + "/" + this->Own + LockEnding, false);
  if (!this->Lock->IsMine())
  {
    Fail(this->Film + ": another process draws part " + std::to_string(options.Part) + " of " +
      std::to_string(options.Parts) + "; wait for it, or give --part K/N");
  }
  this->CheckSameFilm(options.Command);
  this->RemoveScratch(); // what a process left that was killed
}

void FilmParts::RemoveScratch() const
{
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(this->Folder, error))
  {
    if (entry.path().filename().string().rfind(this->Own + "-", 0) == 0)
    {
      std::filesystem::remove(entry.path(), error);
    }
  }
}

void FilmParts::CheckSameFilm(const std::string& command) const
{
  const std::string path = this->Folder + "/" + CommandFile;
  std::error_code error;
  const std::string text = command + "\n";
  if (!std::filesystem::exists(path, error))
  {
    OutputFiles files;
    files.Write(path, text.data(), text.size());
    files.Commit();
    return;
  }
  const std::vector<unsigned char> bytes = ReadBytes(path);
  const std::string difference = FilmDifference(command, { bytes.begin(), bytes.end() });
  if (!difference.empty())
  {
    Fail(this->Folder + " keeps frames of another film: " + difference +
      "; give the same options, or remove the folder");
  }
}

FilmParts::~FilmParts()
{
  this->RemoveScratch();
  this->Lock.reset();
  std::error_code error;
  const std::filesystem::directory_iterator files(this->Folder, error);
  // nothing but the film's command line is in it: nothing is lost
  if (!error && std::distance(begin(files), end(files)) <= 1)
  {
    std::filesystem::remove(this->Folder + "/" + CommandFile, error);
    std::filesystem::remove(this->Folder, error);
  }
}

std::string FilmParts::Scratch(const std::string& name) const
{
  return this->Folder + "/" + this->Own + "-" + name;
}

void FilmParts::Add(const std::string& scratch, int first, int last)
{
  const auto digits = [](int number) {
    const std::string text = std::to_string(number);
    return std::string(text.size() < 8 ? 8 - text.size() : 0, '0') + text;
  };
  const std::string name = "/" + digits(first) + "-" + digits(last) + "." + this->Segment;
  Sync(scratch);
  std::error_code error;
  std::filesystem::rename(scratch, this->Folder + name, error);
  if (error)
  {
    FailFolder(this->Folder, error.message());
  }
}

std::vector<FilmParts::Run> FilmParts::FindRuns() const
{
  const std::regex shape("([0-9]{8})-([0-9]{8})\\." + this->Segment);
  std::vector<Run> runs;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(this->Folder, error))
  {
    const std::string name = entry.path().filename().string();
    std::smatch found;
    if (std::regex_match(name, found, shape))
    {
      runs.push_back({ std::stoi(found[1]), std::stoi(found[2]), name });
    }
  }
  std::sort(runs.begin(), runs.end(), [](const Run& a, const Run& b) { return a.First < b.First; });
  int end = 0;
  for (const Run& run : runs)
  {
    if (run.First < end || run.Last < run.First || run.Last >= this->Plan.Frames)
    {
      Fail(this->Folder + "/" + run.Name + " does not belong to this film; remove it");
    }
    end = run.Last + 1;
  }
  return runs;
}

void FilmParts::JoinWhole(const std::function<void(const std::string& list)>& join)
{
  std::error_code error;
  if (!std::filesystem::exists(this->Folder, error))
  {
    return; // another part's process has joined them
  }
  const LockedFile lock(this->Folder + "/join.lock", true);
  const std::string list = this->WriteList();
  if (!list.empty())
  {
    join(list);
    std::filesystem::remove_all(this->Folder, error);
  }
}

std::string FilmParts::WriteList() const
{
  std::error_code error;
  if (!std::filesystem::exists(this->Folder, error))
  {
    return ""; // another part's process has joined them
  }
  int done = 0;
  std::string text;
  for (const Run& run : this->FindRuns())
  {
    done += run.Last - run.First + 1;
    text += "file '" + run.Name + "'\n";
  }
  if (done < this->Plan.Frames)
  {
    Say(this->Film + ": " + std::to_string(done) + " of " + std::to_string(this->Plan.Frames) +
      " frames are done; the process that draws the last ones joins them");
    return "";
  }
  const std::string path = this->Scratch("list.txt");
  OutputFiles files;
  files.Write(path, text.data(), text.size());
  files.Commit();
  return path;
}
}
