// SPDX-License-Identifier: BSD-3-Clause
#include "StripFile.h"

#include "FileProxy.h"
#include "GPano.h"
#include "ImageSpec.h"
#include "Options/OutputNames.h"
#include "Text/Messages.h"

#include <algorithm>
#include <cstring>

namespace widefov
{
namespace
{
// Pixels along a side of a file's tile. So many rows wait in memory.
constexpr int ColorTile = 256;
constexpr int FloatTile = 64;

// Pixels along a side of a JPEG at the most; beyond it the JPEG library ends the program.
constexpr int JpegLimit = 65500;
}

struct StripFile::Internals
{
  OutputFiles& Files;
  std::string Path;
  OIIO::ImageSpec Spec;
  OIIO::TypeDesc Type;
  int Wanted;          // rows that are written together
  std::size_t RowSize; // bytes
  std::vector<char> Waiting;
  int WaitingRows = 0;
  int Written = 0; // rows
  int File = -1;
  std::unique_ptr<FileProxy> Proxy;
  std::unique_ptr<OIIO::ImageOutput> Output;

  Internals(OutputFiles& files, const std::string& path, OIIO::ImageSpec spec, OIIO::TypeDesc type,
    int wanted);
  void Begin(const std::vector<unsigned char>& insert);
  void Flush();
  [[noreturn]] void FailEncoding();
};

StripFile::Internals::Internals(OutputFiles& files, const std::string& path, OIIO::ImageSpec spec,
  OIIO::TypeDesc type, int wanted)
  : Files(files)
  , Path(path)
  , Spec(std::move(spec))
  , Type(type)
  , Wanted(wanted)
  , RowSize(type.size() * this->Spec.nchannels * this->Spec.width)
{
}

void StripFile::Internals::FailEncoding()
{
  if (this->Proxy && this->Proxy->GetError() != 0)
  {
    const int file = this->File;
    this->File = -1;
    this->Files.Close(file, this->Path, this->Proxy->GetError());
  }
  Fail(this->Path + " cannot hold the picture: " + this->Output->geterror() +
    "; choose another format or size");
}

void StripFile::Internals::Begin(const std::vector<unsigned char>& insert)
{
  const std::string writer = WriterFor(this->Path);
  if (writer == "jpeg" && std::max(this->Spec.width, this->Spec.height) > JpegLimit)
  {
    Fail(this->Path + " cannot hold the picture: a JPEG has at most " + std::to_string(JpegLimit) +
      " pixels a side; write .tif, .png or .exr");
  }
  this->Output = OIIO::ImageOutput::create(writer);
  if (!this->Output)
  {
    Fail("OpenImageIO has no writer for " + writer + ": " + OIIO::geterror() + "; install one");
  }
  if (this->Output->supports("tiles"))
  {
    this->Spec.tile_width = this->Spec.tile_height = this->Wanted;
    this->Spec.attribute("openexr:levelmode", 0); // environments would be promised smaller ones
  }
  this->File = this->Files.Open(this->Path);
  this->Proxy = std::make_unique<FileProxy>(this->File, wfvxmp::PngHeaderEnd, insert);
  this->Output->set_ioproxy(this->Proxy.get());
  if (!this->Output->open(this->Path, this->Spec))
  {
    this->FailEncoding();
  }
}

void StripFile::Internals::Flush()
{
  const int end = this->Written + this->WaitingRows;
  const char* const rows = this->Waiting.data();
  const bool done = this->Spec.tile_width > 0
    ? this->Output->write_tiles(0, this->Spec.width, this->Written, end, 0, 1, this->Type, rows)
    : this->Output->write_scanlines(this->Written, end, 0, this->Type, rows);
  if (!done || this->Proxy->GetError() != 0)
  {
    this->FailEncoding();
  }
  this->Written = end;
  this->WaitingRows = 0;
}

StripFile::StripFile(
  OutputFiles& files, const std::string& path, int width, int height, const PanoramaInfo& info)
  : Internal(new Internals(
      files, path, PictureSpec(width, height, path, info), OIIO::TypeDesc::UINT8, ColorTile))
{
  this->Internal->Begin(PngPanorama(width, height, path, info));
}

StripFile::StripFile(OutputFiles& files, const std::string& path, int width, int height,
  const std::vector<std::string>& channels, const PanoramaInfo& info)
  : Internal(new Internals(
      files, path, FloatSpec(width, height, channels, info), OIIO::TypeDesc::FLOAT, FloatTile))
{
  this->Internal->Begin({});
}

StripFile::~StripFile()
{
  // of a picture that is not whole, which vanishes; the encoder goes before what it writes to
  this->Internal->Output.reset();
  if (this->Internal->File >= 0)
  {
    try
    {
      this->Internal->Files.Close(this->Internal->File, this->Internal->Path, 0);
    }
    catch (const Failure&)
    {
      // another failure is on its way
    }
  }
}

void StripFile::Add(const void* rows, int count)
{
  Internals& in = *this->Internal;
  in.Waiting.resize(in.RowSize * static_cast<std::size_t>(in.Wanted));
  const auto* from = static_cast<const char*>(rows);
  while (count > 0)
  {
    const int n = std::min(count, in.Wanted - in.WaitingRows);
    const std::size_t bytes = in.RowSize * static_cast<std::size_t>(n);
    std::memcpy(&in.Waiting[in.RowSize * static_cast<std::size_t>(in.WaitingRows)], from, bytes);
    from += bytes;
    in.WaitingRows += n;
    count -= n;
    if (in.WaitingRows == in.Wanted || in.Written + in.WaitingRows == in.Spec.height)
    {
      in.Flush();
    }
  }
}

void StripFile::Close()
{
  Internals& in = *this->Internal;
  if (!in.Output->close())
  {
    in.FailEncoding();
  }
  const int file = in.File;
  in.File = -1;
  in.Files.Close(file, in.Path, in.Proxy->GetError());
}
}
