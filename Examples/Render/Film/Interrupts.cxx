// SPDX-License-Identifier: BSD-3-Clause
#include "Interrupts.h"

namespace widefov
{
namespace
{
constexpr int Signals[] = { SIGINT, SIGTERM, SIGHUP };

volatile std::sig_atomic_t HasCome = 0;

void Handle(int)
{
  HasCome = 1;
}
}

Interrupts::Interrupts()
{
  HasCome = 0;
  struct sigaction action = {};
  action.sa_handler = Handle;
  action.sa_flags = SA_RESTART | static_cast<int>(SA_RESETHAND);
  sigemptyset(&action.sa_mask);
  for (int i = 0; i < Count; i++)
  {
    sigaction(Signals[i], &action, &this->Before[i]);
    if (this->Before[i].sa_handler == SIG_IGN)
    {
      sigaction(Signals[i], &this->Before[i], nullptr); // nohup wants it so
    }
  }
}

Interrupts::~Interrupts()
{
  for (int i = 0; i < Count; i++)
  {
    sigaction(Signals[i], &this->Before[i], nullptr);
  }
}

bool Interrupts::Came()
{
  return HasCome != 0;
}
}
