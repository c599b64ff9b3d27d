// SPDX-License-Identifier: BSD-3-Clause
// VTK's errors and warnings, kept instead of printed.
#ifndef WideFoVMessageCatcher_h
#define WideFoVMessageCatcher_h

#include <vtkOutputWindow.h>

#include <mutex>
#include <string>
#include <vector>

namespace widefov
{
class MessageCatcher : public vtkOutputWindow
{
public:
  static MessageCatcher* New();
  vtkTypeMacro(MessageCatcher, vtkOutputWindow);

  // Makes VTK report here for the rest of the program, and silences its logger.
  static void Install();

  void DisplayText(const char* text) override;

  // The first error since the last call, as one line without the place in VTK's
  // source; empty when there was none. The errors kept so far are forgotten.
  static std::string TakeFirstError();

  // The distinct warnings since the last call, the same way.
  static std::vector<std::string> TakeWarnings();

protected:
  MessageCatcher() = default;
  ~MessageCatcher() override = default;

private:
  MessageCatcher(const MessageCatcher&) = delete;
  void operator=(const MessageCatcher&) = delete;

  std::mutex Mutex;
  std::vector<std::string> Errors;
  std::vector<std::string> Warnings;
};
}

#endif
