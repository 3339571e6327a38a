// Two methods of one plugin: one throws a type that nobody else knows, the other does not.
#include "tiny.hpp"

namespace tiny {

/// No std::exception, and known to this file alone.
struct Misfortune {
  int weight;
};

struct Throw {
  signorini::Solution operator()(const signorini::Problem&) const { throw Misfortune{7}; }
};

struct Throwing final : Method<Throw> {
  static constexpr signorini::MethodText kText = text_of("tiny-throwing");
  using Method::Method;
};

struct Quiet final : Method<StandStill> {
  static constexpr signorini::MethodText kText = text_of("tiny-quiet");
  using Method::Method;
};

}  // namespace tiny

SIGNORINI_PLUGIN(tiny::Throwing, tiny::Quiet)
