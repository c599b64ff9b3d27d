// SPDX-License-Identifier: BSD-3-Clause
#include "Program.h"

#include "MessageCatcher.h"
#include "OutputFiles.h"
#include "Signals.h"
#include "Text/Messages.h"

#include <csignal>
#include <new>

namespace widefov
{
int RunProgram(const std::string& name, const std::function<int()>& work)
{
  // a full disk or a closed pipe is an error to report, not a reason to die
  std::signal(SIGXFSZ, SIG_IGN);
  std::signal(SIGPIPE, SIG_IGN);
  const SignalWatch watch(RemoveUnfinished);
  SetProgramName(name);
  MessageCatcher::Install();
  try
  {
    return work();
  }
  catch (const Failure& failure)
  {
    SayError(failure.what());
    return failure.ExitCode;
  }
  catch (const std::bad_alloc&)
  {
    SayError("there is not enough memory; choose smaller data or a smaller picture");
  }
  catch (const std::exception& error)
  {
    SayError(std::string("unexpected: ") + error.what() + "; please report it");
  }
  return ExitFailed;
}
}
