// SPDX-License-Identifier: BSD-3-Clause
// The kinds of files that are read: one table for readers, --help, messages and the documentation.
#ifndef WideFoVFileKinds_h
#define WideFoVFileKinds_h

#include <vtkAlgorithm.h>
#include <vtkSmartPointer.h>

#include <string>
#include <vector>

namespace widefov
{
struct FileKind
{
  const char* Ending; // ".vtp"
  const char* Name;   // of the format, for people
  // Makes a reader of the file, which has not read it yet. Throws std::exception.
  vtkSmartPointer<vtkAlgorithm> (*MakeReader)(const std::string& path);
  bool HasSteps = false; // one file may hold several time steps
};

const std::vector<FileKind>& FileKinds();

// The ending of a path, in lower case.
std::string EndingOf(const std::string& path);

// The kind of a file by its ending. Throws a Failure with ExitFailed if there is no reader, which
// says what to convert the file to.
const FileKind& KindOf(const std::string& path);

// For --list-formats: a line for each kind, or JSON.
std::string FormatList(bool json);

// The times of a file, without its data; none for a kind without steps.
std::vector<double> TimesOfFile(const std::string& path);
}

#endif
