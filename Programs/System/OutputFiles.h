// SPDX-License-Identifier: BSD-3-Clause
// Files that appear whole or not at all.
#ifndef WideFoVOutputFiles_h
#define WideFoVOutputFiles_h

#include <cstddef>
#include <string>
#include <vector>

namespace widefov
{
// As the name of a file: standard input or output.
constexpr const char* StandardStream = "-";

// Throws a Failure with ExitFailed where a file of that name cannot be made: its folder
// is missing or closed, or the name is that of a folder or of a file that was read; or where
// standard output is a terminal.
void CheckWritable(const std::string& path);

// As CheckWritable, but MakeFolderOf will make the folder if it is not there.
void CheckMakeable(const std::string& path);

// Makes the folders of the file that are not there, and says so in a line. Throws a Failure with
// ExitFailed.
void MakeFolderOf(const std::string& path);

// The same where no file can be made in that folder.
void CheckFolder(const std::string& path);

// A folder among the temporary ones that goes with the object. Throws a Failure with ExitFailed
// where there can be none.
class TemporaryFolder
{
public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::string& GetPath() const { return this->Path; }

private:
  std::string Path;
};

// All bytes of a file that this program wrote. Throws a Failure with ExitFailed.
std::vector<unsigned char> ReadBytes(const std::string& path);

// Into an open file; 0, or the errno of what went wrong.
int WriteAllBytes(int file, const char* bytes, std::size_t count);

// Whatever this process has written and not finished goes, and nothing more of it is begun: the
// process ends, and no destructor will do it.
void RemoveUnfinished();

// Several files that appear together. Each is written under a name of its own beside
// its target; Commit renames them. Without Commit nothing on disk changes. What goes to standard
// output is kept until then, too.
class OutputFiles
{
public:
  OutputFiles() = default;
  ~OutputFiles();
  OutputFiles(const OutputFiles&) = delete;
  OutputFiles& operator=(const OutputFiles&) = delete;

  // Throws a Failure with ExitFailed where the disk does not take it all.
  void Write(const std::string& path, const void* bytes, std::size_t count);

  // A file that grows while it is open; it may be read, too. Whoever writes it closes it by
  // Close. Throws a Failure with ExitFailed where it cannot be made.
  int Open(const std::string& path);

  // Throws a Failure with ExitFailed where the file is not whole: `error` is an errno of writing
  // it, or 0.
  void Close(int file, const std::string& path, int error);

  void Commit();

private:
  struct Pending
  {
    std::string Beside;
    std::string Target;
  };
  std::vector<Pending> Files;
};
}

#endif
