// SPDX-License-Identifier: BSD-3-Clause
// Files that tests write.
#ifndef WideFoVDisplayFiles_h
#define WideFoVDisplayFiles_h

#include "Displays/Calibration.h"

#include <initializer_list>
#include <map>
#include <string>

namespace wfv::test
{
// A file in a folder of its own, which goes when it does.
class TemporaryFile
{
public:
  TemporaryFile(const std::string& name, const std::string& bytes);
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  // Writes another file beside it.
  void Add(const std::string& name, const std::string& bytes) const;

  std::string Folder;
  std::string Path;
};

// Numbers of a line, with all their digits.
std::string Text(std::initializer_list<double> numbers);

// The four bytes of a number, the lowest first.
std::string Bytes(std::uint32_t number);
std::string Bytes(float number);

// A portable float map of three channels, the bottom row first.
std::string PfmText(int width, int height, const std::vector<vec3>& values, bool bigEndian = false);

// A grey PNG image of 8 or 16 bits, the upper row first.
std::string PngText(int width, int height, const std::vector<double>& values, int bits = 8);

// A zip archive of these parts.
std::string ZipText(const std::map<std::string, std::string>& parts);

// Returns the error of a reader in one line, or nothing if it succeeds.
template <typename Read>
std::string ErrorOf(const Read& read)
{
  try
  {
    read();
  }
  catch (const displays::FileError& error)
  {
    return error.what();
  }
  return "";
}
}

#endif
