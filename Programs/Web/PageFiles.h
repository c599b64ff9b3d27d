// SPDX-License-Identifier: BSD-3-Clause
// The files in the folder of a web page.
#ifndef WideFoVPageFiles_h
#define WideFoVPageFiles_h

#include "System/OutputFiles.h"

#include <set>
#include <string>
#include <vector>

namespace widefov
{
// The folder of the viewer of web pages. Throws a Failure with ExitFailed if it is not there.
std::string ViewerFolder();

// Throws a Failure with ExitFailed if the folder of a page cannot be made, or has anything else
// than files of an earlier page, or one of these is an input.
void CheckPageFolder(const std::string& folder);

// The files of one page, which appear together.
class PageFiles
{
public:
  explicit PageFiles(const std::string& folder)
    : Folder(folder)
  {
  }

  // Writes a file. Throws a Failure with ExitFailed if the disk is full.
  void Add(const std::string& name, const void* bytes, std::size_t count);

  // Writes a file and its twin NAME.js, which gives the same bytes to a page that was opened
  // without a web server.
  void AddWithTwin(const std::string& name, const std::vector<unsigned char>& bytes);

  // Writes the twin of a file that is there already. Returns false, and writes none, if the file is
  // larger than browsers take as a text.
  bool AddTwin(const std::string& name);

  // Adds the viewer. Then the files appear, and files of an earlier page vanish.
  void Commit();

private:
  void WriteTwin(const std::string& name, const std::vector<unsigned char>& bytes);

  std::string Folder;
  OutputFiles Files;
  std::set<std::string> Names;
};
}

#endif
