// SPDX-License-Identifier: BSD-3-Clause
#include "vtkWideFoVPictureWriter.h"

#include "XmpInFiles.h"

#include "vtkImageData.h"
#include "vtkJPEGWriter.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPNGWriter.h"
#include "vtkUnsignedCharArray.h"

#include <filesystem>
#include <fstream>

vtkStandardNewMacro(vtkWideFoVPictureWriter);

namespace
{
template <typename Writer>
std::vector<unsigned char> InMemory(Writer* writer, vtkImageData* picture)
{
  writer->SetInputData(picture);
  writer->WriteToMemoryOn();
  writer->Write();
  vtkUnsignedCharArray* const bytes = writer->GetResult();
  return bytes ? std::vector<unsigned char>(
                   bytes->GetPointer(0), bytes->GetPointer(0) + bytes->GetNumberOfTuples())
               : std::vector<unsigned char>();
}

// Beside, then renamed.
void WriteWhole(const std::filesystem::path& path, const std::vector<unsigned char>& bytes)
{
  if (path.has_parent_path())
  {
    std::filesystem::create_directories(path.parent_path());
  }
  std::filesystem::path part = path;
  part += ".part";
  std::ofstream file(part, std::ios::binary);
  file.write(
    reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  file.close();
  if (!file)
  {
    std::error_code ignored;
    std::filesystem::remove(part, ignored);
    throw std::runtime_error("cannot write " + path.string() + ": is there space, and permission?");
  }
  std::filesystem::rename(part, path);
}
}

vtkWideFoVPictureWriter::~vtkWideFoVPictureWriter()
{
  this->SetXmp(nullptr);
}

void vtkWideFoVPictureWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Quality: " << this->Quality << "\n"
     << indent << "Xmp: " << (this->Xmp ? this->Xmp : "(none)") << "\n";
}

std::vector<unsigned char> vtkWideFoVPictureWriter::Encode(const std::string& path)
{
  const std::string ending = std::filesystem::path(path).extension().string();
  std::vector<unsigned char> bytes;
  bool complete = true;
  const bool xmp = this->Xmp && this->Xmp[0];
  if (ending == ".png")
  {
    vtkNew<vtkPNGWriter> writer;
    bytes = InMemory(writer.Get(), this->GetInput());
    complete = !xmp || wfvxmp::InsertInPng(bytes, wfvxmp::PngChunk(this->Xmp));
  }
  else if (ending == ".jpg" || ending == ".jpeg")
  {
    vtkNew<vtkJPEGWriter> writer;
    writer->SetQuality(this->Quality);
    bytes = InMemory(writer.Get(), this->GetInput());
    const std::string segment =
      xmp ? wfvxmp::JpegSegment(wfvxmp::JpegPacketName + this->Xmp) : std::string();
    complete = !xmp || (!segment.empty() && wfvxmp::InsertInJpeg(bytes, segment));
  }
  else
  {
    vtkErrorMacro("Cannot write " << path << ": its name has to end in .png, .jpg or .jpeg");
    return bytes;
  }
  if (bytes.empty() || !complete)
  {
    vtkErrorMacro("Cannot write " << path << ": the picture could not be encoded");
    bytes.clear();
  }
  return bytes;
}

void vtkWideFoVPictureWriter::Write()
{
  this->GetInputAlgorithm()->Update();
  if (!this->FileName || !this->GetInput())
  {
    vtkErrorMacro("A picture and the name of a file are needed");
    return;
  }
  try
  {
    const std::vector<unsigned char> bytes = this->Encode(this->FileName);
    if (!bytes.empty())
    {
      WriteWhole(this->FileName, bytes);
    }
  }
  catch (const std::exception& e)
  {
    vtkErrorMacro(<< e.what());
  }
}
