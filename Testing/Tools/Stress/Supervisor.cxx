// SPDX-License-Identifier: BSD-3-Clause
#include "Worker.h"

#include "Text/Messages.h"
#include "Text/OptionValues.h"

#include <csignal>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstring>

namespace wfv
{
namespace stress
{
namespace
{
// A batch that takes longer hangs, seconds.
constexpr int BatchTimeout = 300;

// A process and the lines it prints.
class Child
{
public:
  explicit Child(std::vector<std::string> arguments)
  {
    int ends[2];
    if (pipe(ends) != 0)
    {
      widefov::Fail(std::string("no pipe can be opened: ") + std::strerror(errno));
    }
    std::vector<char*> argv;
    for (std::string& argument : arguments)
    {
      argv.push_back(argument.data());
    }
    argv.push_back(nullptr);
    this->Pid = fork();
    if (this->Pid == 0)
    {
      dup2(ends[1], STDOUT_FILENO);
      close(ends[0]);
      close(ends[1]);
      execv("/proc/self/exe", argv.data());
      _exit(127);
    }
    close(ends[1]);
    this->Output = ends[0];
    if (this->Pid < 0)
    {
      widefov::Fail(std::string("no process can be started: ") + std::strerror(errno));
    }
  }

  ~Child()
  {
    close(this->Output);
    if (!this->Ended)
    {
      this->End();
    }
  }

  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  // The next line; false where none came: the process ended, or did not answer in time.
  bool ReadLine(std::string& line)
  {
    for (;;)
    {
      const std::size_t end = this->Text.find('\n');
      if (end != std::string::npos)
      {
        line = this->Text.substr(0, end);
        this->Text.erase(0, end + 1);
        return true;
      }
      struct pollfd wait = { this->Output, POLLIN, 0 };
      const int ready = poll(&wait, 1, BatchTimeout * 1000);
      char bytes[4096];
      const ssize_t n = ready > 0 ? read(this->Output, bytes, sizeof bytes) : 0;
      this->TimedOut = ready == 0;
      if (n <= 0)
      {
        return false;
      }
      this->Text.append(bytes, std::size_t(n));
    }
  }

  // Why it ended: empty for exit code 0.
  std::string End()
  {
    this->Ended = true;
    if (this->TimedOut)
    {
      kill(this->Pid, SIGKILL);
    }
    int status = 0;
    waitpid(this->Pid, &status, 0);
    if (this->TimedOut)
    {
      return "no answer within " + std::to_string(BatchTimeout) + " seconds";
    }
    if (WIFSIGNALED(status))
    {
      return std::string("signal ") + std::to_string(WTERMSIG(status)) + ", " +
        strsignal(WTERMSIG(status));
    }
    const int code = WEXITSTATUS(status);
    return code == 0 ? "" : "exit code " + std::to_string(code);
  }

private:
  pid_t Pid = -1;
  int Output = -1;
  std::string Text;
  bool TimedOut = false;
  bool Ended = false;
};

std::string Joined(const std::vector<std::string>& names)
{
  return widefov::Join(names, ",");
}

std::vector<std::string> Arguments(
  const StressOptions& o, const std::string& projection, std::size_t skip)
{
  std::vector<std::string> arguments{ "widefov-stress", "--worker", "--skip", std::to_string(skip),
    "--projections", projection, "--technique", Joined(o.Techniques), "--cases", Joined(o.Cases),
    "--seed", std::to_string(o.Seed), "--primitives", std::to_string(o.Primitives), "--tolerance",
    widefov::Text(o.Tolerance) };
  if (o.Batch >= 0)
  {
    arguments.insert(arguments.end(), { "--batch", std::to_string(o.Batch) });
  }
  if (o.AbortAt >= 0)
  {
    arguments.insert(arguments.end(), { "--abort-at", std::to_string(o.AbortAt) });
  }
  return arguments;
}

// Reads what one worker says; returns the technique that it was about when it ended, empty
// where it was between two batches.
std::string Follow(
  Child& child, const std::vector<BatchId>& plan, std::size_t& next, const Listener& listen)
{
  std::string busy;
  std::string line;
  while (child.ReadLine(line)) // to the end of file, so that the worker can say all
  {
    const Json json = Json::parse(line);
    if (json.contains("begin"))
    {
      busy = json["technique"].get<std::string>();
    }
    else if (json.contains("done"))
    {
      busy.clear();
      listen(plan[next], json);
      ++next;
    }
  }
  return busy;
}
}

void Supervise(const StressOptions& o, const std::string& projection, const Listener& listen)
{
  const std::vector<BatchId> plan = PlanOf(o, projection);
  std::size_t next = 0;
  while (next < plan.size())
  {
    Child child(Arguments(o, projection, next));
    const std::size_t before = next;
    const std::string busy = Follow(child, plan, next, listen);
    if (next == plan.size())
    {
      return;
    }
    const std::string why = child.End();
    if (busy.empty() && next == before)
    {
      widefov::Fail(
        "the process that draws ended before it drew (" + why + "); what it says stands above");
    }
    listen(plan[next],
      { { "crash", why.empty() ? "it ended" : why },
        { "technique", busy.empty() ? o.Techniques.front() : busy } });
    ++next;
  }
}
}
}
