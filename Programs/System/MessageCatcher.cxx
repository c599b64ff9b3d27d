// SPDX-License-Identifier: BSD-3-Clause
#include "MessageCatcher.h"

#include "Text/Messages.h"

#include <vtkLogger.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>

#include <algorithm>

namespace widefov
{
namespace
{
// More than a user reads; a reader that complains about every line stays bounded.
constexpr std::size_t MostKept = 16;

// "ERROR: In file, line n\nvtkClass (0x..): what" -> "what".
std::string Plain(const std::string& text)
{
  std::string line = text;
  const std::size_t place = line.find(", line ");
  const std::size_t lineEnd = line.find('\n');
  if (place != std::string::npos && lineEnd != std::string::npos && place < lineEnd)
  {
    line.erase(0, lineEnd + 1);
  }
  const std::size_t object = line.find("): ");
  if (line.compare(0, 3, "vtk") == 0 && object != std::string::npos)
  {
    line.erase(0, object + 3);
  }
  return OneLine(line);
}

void Keep(std::vector<std::string>& kept, const std::string& line)
{
  if (kept.size() < MostKept && std::find(kept.begin(), kept.end(), line) == kept.end())
  {
    kept.push_back(line);
  }
}

MessageCatcher* Installed()
{
  return MessageCatcher::SafeDownCast(vtkOutputWindow::GetInstance());
}
}

vtkStandardNewMacro(MessageCatcher);

void MessageCatcher::Install()
{
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  vtkNew<MessageCatcher> catcher;
  vtkOutputWindow::SetInstance(catcher);
}

void MessageCatcher::DisplayText(const char* text)
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  switch (this->GetCurrentMessageType())
  {
    case MESSAGE_TYPE_ERROR:
      Keep(this->Errors, Plain(text));
      break;
    case MESSAGE_TYPE_WARNING:
    case MESSAGE_TYPE_GENERIC_WARNING:
      Keep(this->Warnings, Plain(text));
      break;
    default:
      break; // chatter
  }
}

std::string MessageCatcher::TakeFirstError()
{
  MessageCatcher* const self = Installed();
  if (self == nullptr)
  {
    return "";
  }
  const std::lock_guard<std::mutex> lock(self->Mutex);
  const std::string first = self->Errors.empty() ? "" : self->Errors.front();
  self->Errors.clear();
  return first;
}

std::vector<std::string> MessageCatcher::TakeWarnings()
{
  MessageCatcher* const self = Installed();
  if (self == nullptr)
  {
    return {};
  }
  const std::lock_guard<std::mutex> lock(self->Mutex);
  std::vector<std::string> warnings;
  warnings.swap(self->Warnings);
  return warnings;
}
}
