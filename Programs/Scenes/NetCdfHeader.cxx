// SPDX-License-Identifier: BSD-3-Clause
// The layout is that of the netCDF classic format specification (Unidata): versions 1, 2
// (64-bit offsets) and 5 (64-bit data); every number is big-endian.
#include "NetCdfHeader.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <vector>

namespace widefov
{
namespace
{
struct Broken : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

using Size = std::uint64_t;

class Header
{
public:
  explicit Header(const std::string& path)
    : File(path, std::ios::binary)
    , FileSize(std::filesystem::file_size(path))
  {
  }

  // False for any other format.
  bool ReadMagic()
  {
    char magic[4] = {};
    this->File.read(magic, 4);
    this->Version = magic[3];
    return this->File && std::string(magic, 3) == "CDF" &&
      (this->Version == 1 || this->Version == 2 || this->Version == 5);
  }

  // Where the last variable ends, in bytes from the start of the file.
  Size End()
  {
    const Size records = this->ReadCount();
    this->ReadDimensions();
    this->SkipAttributes();
    this->ReadList(0x0B, [this] { this->ReadVariable(); });
    if (!this->HasRecords || records == this->Streaming())
    {
      return this->FixedEnd;
    }
    // records interleave: the last one ends with the last of its variables; a single
    // record variable is not padded, so its own size counts
    const Size behind = records == 0 ? 0 : (records - 1) * this->RecordSize;
    return std::max(this->FixedEnd, records == 0 ? 0 : this->LastRecordEnd + behind);
  }

private:
  Size Streaming() const { return this->Version == 5 ? ~Size(0) : 0xffffffffU; }

  Size Read(int bytes)
  {
    Size value = 0;
    for (int i = 0; i < bytes; i++)
    {
      const int c = this->File.get();
      if (c < 0)
      {
        throw Broken("it ends within its header");
      }
      value = value << 8 | static_cast<Size>(c);
    }
    return value;
  }

  Size ReadCount() { return this->Read(this->Version == 5 ? 8 : 4); }

  void Skip(Size bytes)
  {
    const Size padded = (bytes + 3) / 4 * 4;
    if (bytes > this->FileSize)
    {
      throw Broken("its header is damaged");
    }
    this->File.seekg(static_cast<std::streamoff>(padded), std::ios::cur);
  }

  void SkipName() { this->Skip(this->ReadCount()); }

  template <class Element>
  void ReadList(Size tag, const Element& element)
  {
    const Size found = this->Read(4);
    const Size count = this->ReadCount();
    if ((found != tag && (found != 0 || count != 0)) || count > this->FileSize)
    {
      throw Broken("its header is damaged");
    }
    for (Size i = 0; i < count; i++)
    {
      element();
    }
  }

  static Size TypeSize(Size type)
  {
    static const std::vector<Size> sizes{ 0, 1, 1, 2, 4, 4, 8, 1, 2, 4, 8, 8 };
    if (type == 0 || type >= sizes.size())
    {
      throw Broken("its header names an unknown type");
    }
    return sizes[type];
  }

  void ReadDimensions()
  {
    this->ReadList(0x0A, [this] {
      this->SkipName();
      this->Dimensions.push_back(this->ReadCount());
    });
  }

  void SkipAttributes()
  {
    this->ReadList(0x0C, [this] {
      this->SkipName();
      const Size size = TypeSize(this->Read(4));
      const Size count = this->ReadCount();
      this->Skip(count > this->FileSize ? count : count * size);
    });
  }

  // The extent of a variable from its dimensions: the size in the header is capped for
  // large ones.
  void ReadVariable()
  {
    this->SkipName();
    const Size rank = this->ReadCount();
    if (rank > this->Dimensions.size())
    {
      throw Broken("its header is damaged");
    }
    bool isRecord = false;
    Size values = 1;
    for (Size i = 0; i < rank; i++)
    {
      const Size id = this->ReadCount();
      const Size length = id < this->Dimensions.size() ? this->Dimensions[id] : ~Size(0);
      isRecord = isRecord || (i == 0 && length == 0);
      const Size factor = i == 0 && length == 0 ? 1 : length;
      if (factor != 0 && values > (Size(1) << 56) / factor)
      {
        throw Broken("its header announces more data than any file holds");
      }
      values *= factor;
    }
    this->SkipAttributes();
    const Size bytes = values * TypeSize(this->Read(4));
    this->ReadCount(); // the size as written
    const Size begin = this->Read(this->Version == 1 ? 4 : 8);
    this->Place(isRecord, begin, bytes);
  }

  void Place(bool isRecord, Size begin, Size bytes)
  {
    if (begin > this->FileSize)
    {
      throw Broken("it ends before its data begin");
    }
    if (!isRecord)
    {
      this->FixedEnd = std::max(this->FixedEnd, begin + bytes);
      return;
    }
    // with one record variable alone there is no padding between its records
    this->RecordSize = this->HasRecords ? this->PaddedSum + (bytes + 3) / 4 * 4 : bytes;
    this->PaddedSum += (bytes + 3) / 4 * 4;
    this->LastRecordEnd = std::max(this->LastRecordEnd, begin + bytes);
    this->HasRecords = true;
  }

  std::ifstream File;
  Size FileSize;
  int Version = 0;
  std::vector<Size> Dimensions;
  Size FixedEnd = 0;
  bool HasRecords = false;
  Size PaddedSum = 0;
  Size RecordSize = 0;
  Size LastRecordEnd = 0;
};
}

std::string DamagedNetCdf(const std::string& path)
{
  try
  {
    Header header(path);
    if (!header.ReadMagic())
    {
      return "";
    }
    const Size size = std::filesystem::file_size(path);
    const Size end = header.End();
    return end > size
      ? "its header announces " + std::to_string(end) + " bytes, but it has " + std::to_string(size)
      : "";
  }
  catch (const Broken& broken)
  {
    return broken.what();
  }
}
}
