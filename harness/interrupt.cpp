#include "harness/interrupt.hpp"

#include <csignal>

namespace signorini {

namespace {

volatile std::sig_atomic_t flag = 0;

extern "C" void raise_flag(int) { flag = 1; }

}  // namespace

void watch_interrupts() {
  struct sigaction action {};
  action.sa_handler = raise_flag;  // without SA_RESTART: a waiting parent wakes up
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

bool interrupted() { return flag != 0; }

}  // namespace signorini
