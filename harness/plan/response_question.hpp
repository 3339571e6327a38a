#pragma once
// What a case may ask in place of one motion: a whole frequency response.

namespace signorini {

/// Which branches a case is about.
enum class ResponseWay {
  exact,       ///< those of exact orbits, which all others are measured against
  arc_length,  ///< the method's own, each step along the branch
  steps        ///< its answers at one frequency after the other, up and down
};

/// A frequency response that is asked for.
struct ResponseQuestion {
  double from = 1.0, to = 2.0;                ///< ends of the interval of frequencies of the load [rad/s]
  int orders = 2;                             ///< longest period of a motion [forcing periods]
  ResponseWay way = ResponseWay::arc_length;  ///< whose branches
};

}  // namespace signorini
