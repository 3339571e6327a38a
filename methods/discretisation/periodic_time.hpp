#pragma once
// Instants of a periodic motion.

#include <cmath>

namespace signorini {

/// The instant in [0, period) that a time falls on; `period` itself, which rounding may give, is 0 [s].
inline double wrapped_time(double time, double period) {
  const double wrapped = time - period * std::floor(time / period);
  return wrapped < period ? wrapped : 0.0;
}

}  // namespace signorini
