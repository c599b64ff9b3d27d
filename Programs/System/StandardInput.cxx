// SPDX-License-Identifier: BSD-3-Clause
#include "StandardInput.h"

#include "Text/Messages.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <unistd.h>
#include <utility>

namespace widefov
{
namespace
{
constexpr std::size_t PieceBytes = 1 << 16;

// Enough to see the type that VTK's XML files name, behind the longest remark of a writer.
constexpr std::size_t BeginningBytes = 4096;

bool BeginsWith(const std::string& text, const std::string& word)
{
  return text.compare(0, word.size(), word) == 0;
}

// Of binary STL: 80 bytes of anything, then the number of triangles, the highest byte last; no text
// has a zero there, nor a file that one can have that many triangles in.
bool IsBinaryStl(const std::string& text)
{
  return text.size() > 84 && text[83] == '\0';
}

// VTK's XML files say what they are: type="PolyData".
std::string XmlEnding(const std::string& text)
{
  const std::pair<const char*, const char*> types[] = { { "PolyData", ".vtp" },
    { "UnstructuredGrid", ".vtu" }, { "ImageData", ".vti" }, { "StructuredGrid", ".vts" },
    { "RectilinearGrid", ".vtr" } };
  for (const auto& [type, ending] : types)
  {
    if (text.find("type=\"" + std::string(type) + "\"") != std::string::npos)
    {
      return ending;
    }
  }
  return "";
}

// Up to so many bytes; fewer only at the end.
std::string ReadPiece(std::size_t count)
{
  std::string piece(count, '\0');
  std::size_t done = 0;
  while (done < count)
  {
    const ssize_t n = read(STDIN_FILENO, &piece[done], count - done);
    if (n < 0 && errno == EINTR)
    {
      continue;
    }
    if (n < 0)
    {
      Fail("standard input cannot be read: " + std::string(std::strerror(errno)) +
        "; check where it comes from");
    }
    if (n == 0)
    {
      break;
    }
    done += static_cast<std::size_t>(n);
  }
  piece.resize(done);
  return piece;
}

void Copy(std::string piece, const std::string& path)
{
  std::ofstream file(path, std::ios::binary);
  for (; !piece.empty() && file; piece = ReadPiece(PieceBytes))
  {
    file.write(piece.data(), static_cast<std::streamsize>(piece.size()));
  }
  file.close();
  if (!file)
  {
    Fail(
      "standard input cannot be kept in " + path + "; make room, or set TMPDIR to another folder");
  }
}
}

std::string EndingOfData(const std::string& text)
{
  if (BeginsWith(text, "# vtk DataFile"))
  {
    return ".vtk";
  }
  if (BeginsWith(text, "ply"))
  {
    return ".ply";
  }
  if (BeginsWith(text, "glTF"))
  {
    return ".glb";
  }
  if (text.find("<VTKFile") != std::string::npos)
  {
    return XmlEnding(text);
  }
  return BeginsWith(text, "solid") || IsBinaryStl(text) ? ".stl" : "";
}

StandardInput::StandardInput(std::vector<std::string>& names)
{
  const auto name = std::find(names.begin(), names.end(), StandardStream);
  if (name == names.end())
  {
    return;
  }
  if (std::count(names.begin(), names.end(), StandardStream) > 1)
  {
    FailUsage("- is named twice as input; there is one standard input");
  }
  const std::string beginning = ReadPiece(BeginningBytes);
  const std::string ending = EndingOfData(beginning);
  if (ending.empty())
  {
    Fail(beginning.empty()
        ? "standard input is empty; check where it comes from"
        : "standard input is none of .vtk, .vtp, .vtu, .vti, .vts, .vtr, .ply, .stl and .glb; "
          "write it to a file whose ending says what it is");
  }
  this->Folder.emplace();
  *name = this->Folder->GetPath() + "/standard-input" + ending;
  Copy(beginning, *name);
}
}
