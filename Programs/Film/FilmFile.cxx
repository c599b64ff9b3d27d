// SPDX-License-Identifier: BSD-3-Clause
#include "FilmFile.h"

#include "Ffmpeg.h"
#include "FrameFiles.h"
#include "Options/FilmOptions.h"
#include "Options/StereoChoice.h"
#include "Options/StereoLayout.h"
#include "Pictures/EyePictures.h"
#include "SphericalTags.h"
#include "System/OutputFiles.h"
#include "Text/Messages.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>

namespace widefov
{
namespace
{
// A run of frames ends after so many seconds of the film, or so much time: a process that is killed
// loses no more.
constexpr double SecondsOfRun = 4;
constexpr std::chrono::seconds TimeOfRun{ 60 };

std::string Complaint(const ChildProcess& process)
{
  return process.GetComplaint() + "; make room or choose another --codec";
}

// A whole file's bytes.
void CopyFile(const std::string& from, const WriteBytes& write)
{
  std::ifstream file(from, std::ios::binary);
  std::vector<char> block(1 << 20);
  while (file.read(block.data(), static_cast<std::streamsize>(block.size())) || file.gcount() > 0)
  {
    write(block.data(), static_cast<std::size_t>(file.gcount()));
  }
}

// Makes a file whole or not at all of what `make` writes.
void WriteWhole(const std::string& path, const std::function<void(const WriteBytes& write)>& make)
{
  OutputFiles files;
  const int file = files.Open(path);
  int error = 0;
  make([&](const char* bytes, std::size_t count) {
    error = error != 0 ? error : WriteAllBytes(file, bytes, count);
  });
  files.Close(file, path, error);
  files.Commit();
}

// The film with metadata, and ready for players before its end has come.
void WriteTagged(const std::string& from, const SphericalInfo& info, const std::string& to)
{
  const auto edit = [&info](Mp4Box& movie) { TagMovie(movie, info); };
  WriteWhole(to, [&](const WriteBytes& write) { RewriteMovie(from, edit, write); });
}

bool Exists(const std::string& path)
{
  std::error_code error;
  return std::filesystem::exists(path, error);
}
}

std::vector<std::unique_ptr<FilmSink>> OpenSinks(const Options& o, const FilmPlan& plan)
{
  std::vector<std::unique_ptr<FilmSink>> sinks;
  for (const std::string& output : o.Outputs)
  {
    if (FindContainer(output) == nullptr)
    {
      sinks.push_back(std::make_unique<FrameFiles>(o, plan, output));
      continue;
    }
    const std::vector<std::string> paths = FilesOfFilm(o, output);
    for (std::size_t i = 0; i < paths.size(); i++)
    {
      sinks.push_back(std::make_unique<FilmFile>(o, plan, paths[i], i));
    }
  }
  return sinks;
}

const Picture& ArrangedPicture(
  const Options& o, const FilmFrame& frame, std::size_t index, Picture& space)
{
  const StereoLayout& layout = FindStereoLayout(o.Layout);
  if (frame.Drawn.size() < 2 || layout.Columns * layout.Rows == 1)
  {
    return frame.Drawn[index];
  }
  space = Arrange(layout, frame.Drawn)[index];
  return space;
}

FilmFile::FilmFile(
  const Options& o, const FilmPlan& plan, const std::string& path, std::size_t index)
  : What(o)
  , Plan(plan)
  , Path(path)
  , Index(index)
  , Kind(*FindContainer(path))
  , Coding(*FindCodec(CodecNameFor(o.Film, path)))
{
  if (o.Film.Resume && Exists(path) && !Exists(FilmParts::FolderOf(path)))
  {
    Say(path + " is whole already; remove it to draw it again");
    return;
  }
  MakeFolderOf(path);
  CheckWritable(path);
  this->Parts.emplace(path, this->Coding.Segment, o.Film, plan);
}

void FilmFile::StartRun(int frame)
{
  this->Scratch = this->Parts->Scratch("run." + this->Coding.Segment);
  this->Encoder = std::make_unique<ChildProcess>(
    EncodeCommand(this->What.Film, this->Coding, SizeOfFile(this->What), this->Scratch));
  this->FirstOfRun = frame;
  this->RunStart = std::chrono::steady_clock::now();
}

void FilmFile::FailEncoding()
{
  const std::unique_ptr<ChildProcess> encoder = std::move(this->Encoder);
  encoder->Finish();
  std::remove(this->Scratch.c_str());
  Fail(this->Path + " cannot be encoded: " + Complaint(*encoder));
}

void FilmFile::Add(const FilmFrame& frame)
{
  if (this->Encoder && frame.Number != this->Last + 1)
  {
    this->EndRun();
  }
  if (!this->Encoder)
  {
    this->StartRun(frame.Number);
  }
  Picture space;
  const Picture& picture = ArrangedPicture(this->What, frame, this->Index, space);
  if (!this->Encoder->Write(picture.Rgb.data(), picture.Rgb.size()))
  {
    this->FailEncoding();
  }
  this->Last = frame.Number;
  const int run = std::max(1, static_cast<int>(std::lround(SecondsOfRun * this->What.Film.Fps)));
  if ((frame.Number + 1) % run == 0 ||
    std::chrono::steady_clock::now() - this->RunStart > TimeOfRun)
  {
    this->EndRun();
  }
}

void FilmFile::EndRun()
{
  if (!this->Encoder)
  {
    return;
  }
  const std::unique_ptr<ChildProcess> encoder = std::move(this->Encoder);
  if (!FinishFfmpeg(*encoder))
  {
    std::remove(this->Scratch.c_str());
    Fail(this->Path + " cannot be encoded: " + Complaint(*encoder));
  }
  std::error_code error;
  const auto size = std::filesystem::file_size(this->Scratch, error);
  this->Bytes += error ? 0 : static_cast<long long>(size);
  this->Parts->Add(this->Scratch, this->FirstOfRun, this->Last);
}

void FilmFile::Keep()
{
  try
  {
    this->EndRun();
  }
  catch (const Failure&)
  {
    // why the film ends is said already
  }
}

void FilmFile::Finish()
{
  if (this->Parts)
  {
    this->EndRun();
    this->Parts->JoinWhole([this](const std::string& list) { this->Join(list); });
  }
}

void FilmFile::Join(const std::string& list)
{
  const SphericalInfo info = DescribeFilm(this->What);
  Muxing muxing;
  muxing.Audio = this->What.Film.Audio;
  muxing.Seconds = this->Plan.Frames / this->What.Film.Fps;
  const std::string joined = this->Parts->Scratch("joined." + this->Coding.Segment);
  RunFfmpeg(JoinCommand(list, this->Coding, joined), this->Path);
  const std::string muxed = this->Parts->Scratch("muxed" + this->Kind.Ending);
  if (this->Kind.IsMp4)
  {
    RunFfmpeg(MuxCommand(joined, this->Kind, this->Coding, muxing, muxed), this->Path);
    WriteTagged(muxed, info, this->Path);
    return;
  }
  // ffmpeg takes to Matroska what it reads of version 2
  const std::string tagged = this->Parts->Scratch("tagged." + this->Coding.Segment);
  WriteTagged(joined, info, tagged);
  muxing.StereoMode = MatroskaStereoMode(info);
  muxing.Spherical = SphericalXml(info);
  RunFfmpeg(MuxCommand(tagged, this->Kind, this->Coding, muxing, muxed), this->Path);
  WriteWhole(this->Path, [&](const WriteBytes& write) { CopyFile(muxed, write); });
}
}
