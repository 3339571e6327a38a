#pragma once

namespace signorini {

/// From here on SIGINT and SIGTERM only raise a flag, so that a run can end with its records whole.
void watch_interrupts();

/// True once one of them came.
bool interrupted();

}  // namespace signorini
