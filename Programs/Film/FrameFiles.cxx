// SPDX-License-Identifier: BSD-3-Clause
#include "FrameFiles.h"

#include "FrameOwner.h"
#include "Options/FilmOptions.h"
#include "Pictures/PictureFiles.h"
#include "System/InputFiles.h"
#include "System/OutputFiles.h"
#include "Text/Messages.h"

#include <filesystem>

namespace widefov
{
FrameFiles::FrameFiles(const Options& o, const FilmPlan& plan, const std::string& output)
  : What(o)
  , Frames(plan.Frames)
  , Present(static_cast<std::size_t>(plan.Frames))
{
  for (const std::string& name : FilesOfFilm(o, output))
  {
    this->Names.push_back(*NumberPattern::Parse(name));
  }
  this->CheckInputs();
  for (const NumberPattern& name : this->Names)
  {
    MakeFolderOf(name.Name(1));
    CheckWritable(name.Name(1));
  }
  if (o.Film.Resume || o.Film.Parts > 1)
  {
    this->FindPresent();
  }
  this->SayWhatIsLeft();
}

void FrameFiles::CheckInputs() const
{
  for (const NumberPattern& name : this->Names)
  {
    const std::filesystem::path folder = std::filesystem::path(name.Name(1)).parent_path();
    for (const std::string& input : NotedInputs())
    {
      const std::filesystem::path file(input);
      const bool beside = file.parent_path() == PlainName(folder.empty() ? "." : folder.string());
      const auto number = name.NumberIn((folder / file.filename()).string());
      if (beside && number && *number >= 1 && *number <= this->Frames)
      {
        Fail(name.Name(*number) + " is an input file; write somewhere else");
      }
    }
  }
}

// Notes the frames that are there, and those that are to be drawn again.
void FrameFiles::FindPresent()
{
  for (int frame = 0; frame < this->Frames; frame++)
  {
    bool all = true;
    for (const NumberPattern& name : this->Names)
    {
      const std::string path = name.Name(frame + 1LL);
      const FrameState state = StateOfFrame(path);
      all = all && state == FrameState::Whole;
      if (state == FrameState::Whole)
      {
        CheckOwner(path, this->What.Film.Command);
      }
      else if (state == FrameState::Cut && this->What.Film.Resume)
      {
        Say(path + " is cut short, and is drawn again");
      }
    }
    this->Present[static_cast<std::size_t>(frame)] = all && this->What.Film.Resume;
  }
}

// Frames behind the last one, which a longer film has left.
void FrameFiles::SayWhatIsLeft() const
{
  for (const NumberPattern& name : this->Names)
  {
    const std::filesystem::path folder = std::filesystem::path(name.Name(1)).parent_path();
    int count = 0;
    std::error_code error;
    for (const auto& entry :
      std::filesystem::directory_iterator(folder.empty() ? "." : folder, error))
    {
      const auto number = name.NumberIn((folder / entry.path().filename()).string());
      count += number && *number > this->Frames ? 1 : 0;
    }
    if (count > 0)
    {
      Say(std::to_string(count) + (count == 1 ? " older frame" : " older frames") + " after " +
        name.Name(this->Frames) + " will stay; remove them if they are not of this film");
    }
  }
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
