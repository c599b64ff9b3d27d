// SPDX-License-Identifier: BSD-3-Clause
// Parts of zip archives, in memory: nothing is ever unpacked to the disk.
#ifndef WideFoVZipFile_h
#define WideFoVZipFile_h

#include "Calibration.h"

#include <memory>

struct zip;

namespace wfv::displays
{
class ZipFile
{
public:
  // Throws a FileError where there is no archive, or where one of its parts has a name that points
  // outside of it.
  explicit ZipFile(const std::string& path);
  ~ZipFile();
  ZipFile(const ZipFile&) = delete;
  ZipFile& operator=(const ZipFile&) = delete;

  // Names of the parts.
  const std::vector<std::string>& Names() const { return this->Parts; }

  // The bytes of the part with this name. Throws a FileError.
  std::string Read(const std::string& name) const;

private:
  std::string Path;
  zip* Archive;
  std::vector<std::string> Parts;
};

// True for an absolute name and for one that leaves its folder by "..".
bool PointsOutside(const std::string& name);
}

#endif
