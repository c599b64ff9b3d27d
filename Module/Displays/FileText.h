// SPDX-License-Identifier: BSD-3-Clause
// Reads files, and takes lines and numbers from their text.
#ifndef WideFoVFileText_h
#define WideFoVFileText_h

#include "Calibration.h"

#include <string_view>

namespace wfv::displays
{
// Largest size of a file, or of a member of an archive, bytes.
constexpr std::size_t LargestFile = std::size_t{ 1 } << 30;

// Pixels, nodes or triangles at the most; a larger number in a file is taken for damage.
constexpr std::size_t LargestCount = std::size_t{ 1 } << 26;

// All of a file. Throws FileError where it is missing, no regular file, too large or unreadable.
std::string ReadBytes(const std::string& path);

// The numbers of a line, one after the other, with blanks or one of the separators between.
class Numbers
{
public:
  explicit Numbers(std::string_view text, char separator = ' ')
    : Rest(text)
    , Separator(separator)
  {
  }

  // Takes the next number. False, and nothing taken, where there is none.
  bool Next(double& value);

  // Takes so many numbers. False unless all are there.
  template <std::size_t N>
  bool All(std::array<double, N>& values)
  {
    for (double& value : values)
    {
      if (!this->Next(value))
      {
        return false;
      }
    }
    return true;
  }

  // Returns the rest of the text, trimmed.
  std::string_view Remainder() const;

private:
  std::string_view Rest;
  char Separator;
};

// The lines of a text that are not empty, without blanks around, and their numbers.
class Lines
{
public:
  Lines(std::string path, std::string_view text)
    : Path(std::move(path))
    , Rest(text)
  {
  }

  // Goes to the next line. False at the end.
  bool Next();

  std::string_view Text() const { return this->Line; }

  // Throws a FileError that names the file and this line.
  [[noreturn]] void Fail(const std::string& problem) const;

  // Returns the N finite numbers of this line. Throws a FileError if the line has anything else.
  template <std::size_t N>
  std::array<double, N> Finite(const char* what, char separator = ' ') const
  {
    std::array<double, N> values{};
    Numbers numbers(this->Line, separator);
    bool good = numbers.All(values) && numbers.Remainder().empty();
    for (const double value : values)
    {
      good = good && std::isfinite(value);
    }
    if (!good)
    {
      this->Fail(std::string("needs ") + what);
    }
    return values;
  }

private:
  std::string Path;
  std::string_view Rest;
  std::string_view Line;
  int Number = 0;
};

// The text without blanks around.
std::string_view Trimmed(std::string_view text);

// In lower case, ASCII letters alone.
std::string LowerCase(std::string_view text);

// The columns and rows that this line says of a mesh. Throws a FileError unless there are 2 of
// each.
std::array<std::size_t, 2> GridSize(const Lines& lines);

// Throws a FileError that says that the file is cut, unless all nodes are there.
void CheckNodeCount(const std::string& path, std::size_t there, std::size_t all);

// A whole number from 1 to LargestCount; 0: the value is none.
std::size_t CountOf(double value);
}

#endif
