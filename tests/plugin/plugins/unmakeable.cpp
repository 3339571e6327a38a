// A method that cannot be made with its own defaults.
#include "tiny.hpp"

namespace tiny {

struct Refusal {};

struct Unmakeable final : Method<StandStill> {
  static constexpr signorini::MethodText kText = text_of("tiny-unmakeable");
  explicit Unmakeable(const Options& options) : Method(options) { throw Refusal{}; }
};

}  // namespace tiny

SIGNORINI_PLUGIN(tiny::Unmakeable)
