// SPDX-License-Identifier: BSD-3-Clause
// A picture that goes to its file while it is drawn, from the top: it need not fit in memory.
#ifndef WideFoVStripFile_h
#define WideFoVStripFile_h

#include "ImageOutput.h"
#include "System/OutputFiles.h"

#include <memory>
#include <string>
#include <vector>

namespace widefov
{
// TIFF and EXR in tiles, PNG and JPEG in rows. The file appears with those of `files`, which
// outlives this.
class StripFile
{
public:
  // Three channels of a byte, or float channels of these names. Throw a Failure with ExitFailed
  // where the format does not hold a picture of that size, or the file cannot be made.
  StripFile(
    OutputFiles& files, const std::string& path, int width, int height, const PanoramaInfo& info);
  StripFile(OutputFiles& files, const std::string& path, int width, int height,
    const std::vector<std::string>& channels, const PanoramaInfo& info);
  ~StripFile();
  StripFile(const StripFile&) = delete;
  StripFile& operator=(const StripFile&) = delete;

  // The next rows. Throws a Failure with ExitFailed where the disk does not take them.
  void Add(const void* rows, int count);

  // After the last one. Throws a Failure with ExitFailed.
  void Close();

private:
  struct Internals;
  std::unique_ptr<Internals> Internal;
};
}

#endif
