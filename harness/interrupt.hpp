#pragma once
// SIGINT and SIGTERM as a flag.

namespace signorini {

/// From here on SIGINT and SIGTERM only raise a flag, so that a run can end with its records whole.
void watch_interrupts();

/// True once a signal has come.
bool interrupted();

}  // namespace signorini
